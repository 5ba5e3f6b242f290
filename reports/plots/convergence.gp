# Error against element length and against CPU time, one curve a kernel and placement, with the
# slope of second order. Data blocks: elements, element length, error, CPU seconds; first line of
# each block its title.
do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 960,470 dynamic enhanced font "DejaVu Sans,13" background "white"
  } else {
    set terminal pngcairo size 960,470 enhanced font "DejaVu Sans,10"
  }
  set output name.".".kind
  set multiplot
  set logscale xy
  set format "10^{%T}"
  set grid lc rgb "#dddddd"
  set tmargin at screen 0.89
  set bmargin at screen 0.15
  set ylabel "relative L_2 error of σ′ (–)" offset 0.5,0
  count = int(curves)
  array colour[6] = ["#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00"]
  array shape[6] = [4, 7, 9, 5, 13, 11]
  do for [panel=1:2] {
    set lmargin at screen (panel == 1 ? 0.09 : 0.59)
    set rmargin at screen (panel == 1 ? 0.48 : 0.98)
    set xlabel (panel == 1 ? "element length h (m)" : "CPU time of the run (s)")
    if (panel == 1) {
      set label 1 caption at screen 0.5,0.955 center font ",15" noenhanced
      set key at graph 0.04,0.96 left top reverse Left noenhanced samplen 2
      h0 = real(triangle_h)
      e0 = real(triangle_error)
      set arrow 1 from h0,e0 to 2*h0,e0 nohead lc rgb "#555555"
      set arrow 2 from 2*h0,e0 to 2*h0,4*e0 nohead lc rgb "#555555"
      set arrow 3 from h0,e0 to 2*h0,4*e0 nohead lc rgb "#555555"
      set label 2 "2" at 2.15*h0,2*e0 textcolor rgb "#555555"
    } else {
      unset key
      unset arrow
      unset label
    }
    plot for [i=1:count] name.".dat" index (i-1) using (panel == 1 ? $2 : $4):3 \
        with linespoints lw 1.5 pointsize 0.8 pointtype shape[i] lc rgb colour[i] \
        title value(sprintf("curve%d", i))
  }
  unset multiplot
  unset output
}
