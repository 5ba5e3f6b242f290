# Small multiples: one row a scene (row1, row2, ...), effective stress on the left, pore pressure on
# the right; material points over the reference, fronts dashed and named, empty elements shaded.
# Data blocks of a row: reference (x, stress, pressure), solid points (x, stress), fluid points
# (x, pressure); x in m, stress and pressure over the load.
count = int(rows)
do for [kind in kinds] {
  if (kind eq "svg") {
    set terminal svg size 960,98+count*205 dynamic enhanced font "DejaVu Sans,13" background "white"
  }
  if (kind eq "png") {
    set terminal pngcairo size 960,98+count*205 enhanced font "DejaVu Sans,10"
  }
  if (kind eq "pdf") {
    set terminal pdfcairo size (960)/96.0,(98+count*205)/96.0 enhanced font "DejaVu Sans,9.5"
  }
  set output name.".".kind
  scale = kind eq "svg" ? 1.25 : 1.0  # sizes are in pixels there
  set multiplot
  set xrange [0:real(x_end)]
  set grid lc rgb "#dddddd"
  set style fill solid 1.0 noborder
  strip = 1.0/(98+count*205)
  do for [r=1:count] {
    set tmargin at screen 1-strip*(60+(r-1)*205)
    set bmargin at screen 1-strip*(60+(r-1)*205+155)
    do for [column=1:2] {
      set lmargin at screen (column == 1 ? 0.075 : 0.570)
      set rmargin at screen (column == 1 ? 0.485 : 0.980)
      unset label
      if (r == 1 && column == 1) {
        set label 1 caption at screen 0.5,1-strip*18 center font sprintf(",%g", 12*scale) noenhanced
      }
      if (column == 1) {
        set label 2 value(sprintf("row%d", r)) at graph 0,1.09 left noenhanced
      }
      unset arrow
      unset object
      unset key
      gaps = value(sprintf("gaps%d", r))
      if (words(gaps) > 0) {
        do for [k=1:words(gaps)/2] {
          set object k rectangle from real(word(gaps, 2*k-1)),graph 0 \
              to real(word(gaps, 2*k)),graph 1 behind \
              fillcolor rgb "#bbbbbb" fillstyle solid border linecolor rgb "#999999"
        }
      }
      fronts = value(sprintf("fronts%d", r))
      waves = value(sprintf("waves%d", r))
      do for [i=1:words(fronts)] {
        set arrow i from real(word(fronts, i)),graph 0 to real(word(fronts, i)),graph 1 \
            nohead dashtype 2 lc rgb "#888888"
        if (i <= words(waves)) {
          set label 10+i word(waves, i) at real(word(fronts, i)),graph 0.93 left offset 0.3,0 \
              textcolor rgb "#444444"
        }
      }
      set yrange [real(column == 1 ? stress_low : pressure_low): \
                  real(column == 1 ? stress_high : pressure_high)]
      set ylabel (column == 1 ? "effective stress / q  (–)" : "pore pressure / q  (–)") offset 1,0
      if (r == count) { set xlabel "x  (m)" } else { unset xlabel }
      if (r == count) {
        set key at graph 1.0,screen strip*11 right center horizontal noenhanced samplen 2
      }
      base = 3*(r-1)
      plot name.".dat" index (base+column) using 1:2 with points \
               pointtype (column == 1 ? 7 : 9) pointsize 0.35 \
               lc rgb (column == 1 ? "#0072B2" : "#D55E00") title "material points", \
           name.".dat" index base using 1:(column == 1 ? $2 : $3) with lines lw 1.4 \
               lc rgb "black" title "reference"
    }
  }
  unset multiplot
  unset output
}
