# Error of the routes of the reference against CPU time a value, one panel a regime of drag. Data
# blocks for each panel: contour, bromwich, modal; columns: microseconds a value, error of the load.
do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 960,400 dynamic enhanced font "DejaVu Sans,13" background "white"
  } else {
    set terminal pngcairo size 960,400 enhanced font "DejaVu Sans,10"
  }
  set output name.".".kind
  set multiplot
  count = int(panels)
  set logscale xy
  set format "10^{%T}"
  set grid lc rgb "#dddddd"
  set xrange [real(fastest):real(slowest)]
  set yrange [1e-16:10]
  set tmargin at screen 0.80
  set bmargin at screen 0.17
  set label 1 caption at screen 0.5,0.955 center font ",15" noenhanced
  set xlabel "CPU time a value (µs)"
  array colour[3] = ["#0072B2", "#D55E00", "#009E73"]
  array shape[3] = [7, 9, 5]
  array route[3] = ["contour", "bromwich (GSL)", "modal (FFTW)"]
  do for [panel=1:count] {
    set lmargin at screen 0.085 + (panel-1)*0.305
    set rmargin at screen 0.085 + (panel-1)*0.305 + 0.275
    if (panel == 1) {
      set ylabel "error, share of the load (–)" offset 0.5,0
      set key at graph 0.98,0.97 right top Right samplen 2
    } else {
      unset ylabel
      set format y ""
      unset key
    }
    set label 2 value(sprintf("title%d", panel)) at graph 0.5,1.06 center noenhanced
    plot for [i=1:3] name.".dat" index (3*(panel-1)+i-1) using 1:($2 < 1e-16 ? 1.2e-16 : $2) \
        with linespoints lw 1.5 pointsize 0.8 pointtype shape[i] lc rgb colour[i] title route[i]
    unset label 1
  }
  unset multiplot
  unset output
}
