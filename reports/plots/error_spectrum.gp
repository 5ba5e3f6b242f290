# Amplitudes of a field and of its error over cells in a wavelength, one panel and one data block a
# method. Waves shorter than four cells, which no grid resolves, are shaded.
panels = int(count)
rows = (panels+1)/2
high = 90+rows*300
do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 960,high dynamic enhanced font "DejaVu Sans,13" background "white"
  } else {
    set terminal pngcairo size 960,high enhanced font "DejaVu Sans,10"
  }
  set output name.".".kind
  set multiplot
  set grid lc rgb "#dddddd"
  set logscale xy
  set xrange [2:400]
  set yrange [1e-8:1]
  set format y "10^{%T}"
  set style fill solid 1.0 noborder
  do for [panel=1:panels] {
    row = (panel-1)/2
    side = (panel-1)%2
    set lmargin at screen 0.085+0.48*side
    set rmargin at screen 0.50+0.48*side
    set tmargin at screen 1-(75.0+row*300)/high
    set bmargin at screen 1-(75.0+row*300+225)/high
    unset label
    unset object
    set object 1 rectangle from 2,graph 0 to 4,graph 1 behind fillcolor rgb "#e8e8e8"
    if (panel == 1) { set label 1 caption at screen 0.5,1-22.0/high center font ",15" noenhanced }
    set label 2 value(sprintf("method%d", panel)) at graph 0.5,1.05 center noenhanced
    set ylabel (side == 0 ? "amplitude / q  (–)" : "")
    set xlabel (row == rows-1 ? "cells in a wavelength  (–)" : "")
    if (panel == 1) { set key left top Left reverse samplen 2 } else { unset key }
    plot name.".dat" index panel-1 using 1:2 with lines lw 1.2 lc rgb "#999999" title "effective stress", \
         name.".dat" index panel-1 using 1:3 with points pointtype 7 pointsize 0.35 lc rgb "#D55E00" \
             title "its error"
  }
  unset multiplot
  unset logscale
  unset output
}
