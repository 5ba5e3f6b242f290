# The s plane of one value of the reference: size of the integrand as colour, singularities, and the
# contour with its nodes; one panel a value. Data blocks for each panel: the field (Re s t, Im s t,
# log10 of the size), the nodes, the branch points. Axes count in 1/t.
do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 960,430 dynamic enhanced font "DejaVu Sans,13" background "white"
  } else {
    set terminal pngcairo size 960,430 enhanced font "DejaVu Sans,10"
  }
  set output name.".".kind
  set multiplot
  count = int(panels)
  set palette defined (-12 "#ffffff", -6 "#c6dbef", -2 "#6baed6", 0 "#2171b5", 2 "#fdae61", 8 "#d7301f")
  set cbrange [-12:8]
  set label 1 caption at screen 0.5,0.955 center font ",15" noenhanced
  set xlabel "Re s · t (–)"
  set tmargin at screen 0.80
  set bmargin at screen 0.16
  do for [panel=1:count] {
    width = 0.80/count
    left = 0.075 + (panel-1)*(width + 0.035)
    set lmargin at screen left
    set rmargin at screen left + width - 0.02
    if (panel == 1) { set ylabel "Im s · t (–)" offset 1,0 } else { unset ylabel }
    if (panel == count) {
      set colorbox user origin screen 0.925,0.16 size screen 0.015,0.64
      set cblabel "log_{10} of |integrand · s|, share of the load" offset 1.2,0
    } else { unset colorbox }
    right_end = real(value(sprintf("right%d", panel)))
    left_end = real(value(sprintf("left%d", panel)))
    height = real(value(sprintf("height%d", panel)))
    cut = real(value(sprintf("cut%d", panel)))
    set xrange [left_end:right_end]
    set yrange [0:height]
    set label 2 value(sprintf("title%d", panel)) at graph 0.5,1.06 center noenhanced
    set key at graph 0.02,0.97 left top Left reverse samplen 1.5 opaque
    b = 3*(panel-1)
    set arrow 1 from (cut < left_end ? left_end : cut),0 to 0,0 nohead front lw 7 lc rgb "#000000"
    plot name.".dat" index b using 1:2:3 with image notitle, \
         name.".dat" index (b+1) using 1:2 with linespoints lw 1.2 pointtype 7 pointsize 0.35 lc rgb "#000000" title "contour and nodes", \
         name.".dat" index (b+2) using 1:2 with points pointtype 2 pointsize 1.6 lw 2.5 lc rgb "#000000" title "branch point", \
         NaN with lines lw 7 lc rgb "#000000" title "cut"
    unset label 1
    unset arrow 1
  }
  unset multiplot
  unset output
}
