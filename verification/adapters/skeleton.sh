#!/bin/sh
# An adapter to copy: runs a solver on a case of porowave and hands over its points.
# Usage: skeleton.sh SOLVER.awk CASE.toml OUTPUT.csv
# Exit codes: 0 done; 1 the case is not for this solver, or it failed (the message goes to the store).
set -eu
solver=$1 case=$2 output=$3

# value TABLE KEY [DEFAULT]: a value of the case; every one stands on a line of its own.
value() {
  found=$(awk -v table="[$1]" -v key="$2" '
    /^\[/ { here = ($1 == table) }
    here && $1 == key && $2 == "=" { sub(/^[^=]*= */, ""); sub(/ *(#.*)?$/, ""); gsub(/"/, ""); print; exit }
  ' "$case")
  if [ -z "$found" ] && [ $# -lt 3 ]; then echo "[$1] $2 is missing" >&2; exit 1; fi
  echo "${found:-${3-}}"
}

# What the solver cannot do is said, not computed wrongly.
expect() {
  [ "$(value "$1" "$2")" = "$3" ] || { echo "only $2 = $3 is possible here" >&2; exit 1; }
}
expect column near drained_traction
expect column far rigid_sealed
expect load shape sin4_pulse

# The solver gets its values as -v name=value. Change units, names and signs here; this solver takes
# porowave's: SI, stress positive in tension, pressure in compression, x from the loaded end.
set --
for key in porosity grain_density fluid_density constrained_modulus fluid_bulk_modulus \
           intrinsic_permeability fluid_viscosity; do
  given=$(value material $key)
  set -- "$@" -v "$key=$given"
done
len=$(value column length)
duration=$(value load duration)
magnitude=$(value load magnitude 1)
elements=$(value discretization elements)
end=$(value time end)
courant=$(value time courant 0.5)
set -- "$@" -v "len=$len" -v "duration=$duration" -v "magnitude=$magnitude" \
       -v "elements=$elements" -v "end=$end" -v "courant=$courant"

# Its output appears under its name when it is complete. Scratch files belong beside it: several
# cases run at a time, each with a folder of its own for case and output.
awk "$@" -f "$solver" > "$output.part"
mv "$output.part" "$output"
