# Error of speed (top) and of amplitude (bottom) of the fast wave (left) and of the slow one, over
# cells in a wavelength. One data block a method: cells, then speed and amplitude of either wave.
array colour[6] = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#000000"]
do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 960,760 dynamic enhanced font "DejaVu Sans,13" background "white"
  } else {
    set terminal pngcairo size 960,760 enhanced font "DejaVu Sans,10"
  }
  set output name.".".kind
  set multiplot
  set grid lc rgb "#dddddd"
  set logscale xy
  set xrange [2.5:100]
  set xtics (3, 5, 10, 20, 50, 100)
  set format y "10^{%T}"
  do for [panel=0:3] {
    row = panel/2
    side = panel%2
    set lmargin at screen 0.09+0.48*side
    set rmargin at screen 0.50+0.48*side
    set tmargin at screen 0.845-0.42*row
    set bmargin at screen 0.505-0.42*row
    unset label
    set yrange [(row == 0 ? 1e-6 : 1e-8):1]
    if (panel == 0) { set label 1 caption at screen 0.5,0.975 center font ",15" noenhanced }
    set label 2 (side == 0 ? "fast wave (P1)" : "slow wave (P2)") at graph 0.5,1.045 center
    set ylabel (side == 1 ? "" : (row == 0 ? "|c/c_{exact} − 1|  (–)" \
                                             : "|A/A_{exact} − 1| a wavelength  (–)"))
    set xlabel (row == 1 ? "cells in a wavelength  (–)" : "")
    if (panel == 0) {
      set key at screen 0.5,0.945 center top horizontal noenhanced samplen 3 maxrows 2
    } else { unset key }
    plot for [k=1:int(count)] name.".dat" index k-1 using 1:(abs(column(2+2*(panel%2)+panel/2)) > 0 ? abs(column(2+2*(panel%2)+panel/2)) : NaN) \
         with lines lw 2 dashtype k lc rgb colour[1+(k-1)%6] title value(sprintf("method%d", k))
  }
  unset multiplot
  unset logscale
  unset output
}
