# Amplitudes of a field and of its error over cells in a wavelength, one panel and one data block a
# method. Waves shorter than four cells, which no grid resolves, are shaded.
panels = int(count)
rows = (panels+1)/2
high = 90+rows*300
do for [kind in kinds] {
  if (kind eq "svg") {
    set terminal svg size 960,high dynamic enhanced font "DejaVu Sans,13" background "white"
  }
  if (kind eq "png") {
    set terminal pngcairo size 960,high enhanced font "DejaVu Sans,10"
  }
  if (kind eq "pdf") {
    set terminal pdfcairo size (960)/96.0,(high)/96.0 enhanced font "DejaVu Sans,9.5"
  }
  set output name.".".kind
  scale = kind eq "svg" ? 1.25 : 1.0  # sizes are in pixels there
  set multiplot
  set grid lc rgb "#dddddd"
  set logscale xy
  set xrange [2:real(longest)]
  set yrange [1e-8:real(highest)]
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
    set object 1 rectangle from 2,graph 0 to 4,graph 1 behind fillcolor rgb "#e8e8e8" \
        fillstyle solid noborder
    if (panel == 1) { set label 1 caption at screen 0.5,1-22.0/high center font sprintf(",%g", 12*scale) noenhanced }
    detail = value(sprintf("detail%d", panel))
    set label 2 value(sprintf("method%d", panel)) at graph 0.5,(detail eq "" ? 1.05 : 1.12) \
        center noenhanced
    if (detail ne "") {
      set label 3 detail at graph 0.5,1.045 center font sprintf(",%g", 9*scale) noenhanced
    }
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
