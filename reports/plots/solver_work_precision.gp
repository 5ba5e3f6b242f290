# Error of the methods of the solver against CPU time, one panel a family, its legend below. Data
# blocks: the best of all, then one a method; columns: CPU seconds, error.
do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 1080,580 dynamic enhanced font "DejaVu Sans,13" background "white"
  } else {
    set terminal pngcairo size 1080,580 enhanced font "DejaVu Sans,10"
  }
  set output name.".".kind
  set multiplot
  count = int(curves)
  set logscale xy
  set format "10^{%T}"
  set grid lc rgb "#dddddd"
  set xrange [real(fastest):real(slowest)]
  set yrange [real(lowest):real(highest)]
  set tmargin at screen 0.86
  set bmargin at screen 0.41
  set xlabel "CPU time of the run (s)"
  array colour[8] = ["#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", \
                     "#7F5200"]
  array shape[8] = [4, 7, 9, 5, 13, 11, 6, 8]
  array family[3] = ["shape and apic", "moving least squares", "staggered4"]
  do for [panel=1:3] {
    set lmargin at screen 0.075 + (panel-1)*0.31
    set rmargin at screen 0.075 + (panel-1)*0.31 + 0.285
    set key at screen 0.075 + (panel-1)*0.31, screen 0.30 left top Left reverse noenhanced \
        samplen 3.5
    if (panel == 1) {
      set ylabel "largest relative L_2 error of the four fields (–)" offset 0.5,0
      set label 1 caption at screen 0.5,0.955 center font ",14" noenhanced
    } else {
      unset ylabel
      set format y ""
      unset label 1
    }
    set label 2 family[panel] at graph 0.5,1.05 center noenhanced
    # Recovered strains have the colours of the kernels that they are used with.
    style = 0
    dashed = 0
    array place[count]
    do for [i=1:count] {
      if (int(word(panels, i)) == panel) {
        if (int(word(dashes, i)) == 1) { style = style + 1; place[i] = style }
        if (int(word(dashes, i)) == 2) { dashed = dashed + 1; place[i] = dashed }
      } else {
        place[i] = 0
      }
    }
    plot name.".dat" index 0 using 1:2 with lines lw 6 lc rgb "#cccccc" notitle, \
        for [i=1:count] name.".dat" index i using (place[i] > 0 ? $1 : NaN):2 \
        with linespoints lw 1.3 pointsize 0.7 dashtype int(word(dashes, i)) \
        pointtype shape[place[i] > 0 ? place[i] : 1] \
        lc rgb colour[place[i] > 0 ? place[i] : 1] \
        title (place[i] > 0 && int(word(dashes, i)) == 1 ? value(sprintf("title%d", i)) : ""), \
        NaN with lines lw 1.3 dashtype 2 lc rgb "#555555" \
        title (dashed > 0 ? "the same with recovered strains" : "")
  }
  unset multiplot
  unset output
}
