# A run over the reference, one data block a time: x, effective stress, pore pressure, the same of
# the reference. The GIF shows all times, SVG and PNG the last.
last = words(times)
do for [kind in "svg png gif"] {
  if (kind eq "svg") {
    set terminal svg size 960,420 dynamic enhanced font "DejaVu Sans,13" background "white"
  }
  if (kind eq "png") {
    set terminal pngcairo size 960,420 enhanced font "DejaVu Sans,10"
  }
  if (kind eq "gif") {
    set terminal gif animate delay 8 loop 0 optimize size 960,420 enhanced font "DejaVu Sans,10"
  }
  set output name.".".kind
  set xrange [0:real(x_end)]
  set yrange [-1.15*real(high):1.15*real(high)]
  set grid lc rgb "#dddddd"
  set style fill solid 1.0 noborder
  set xlabel "x  (m)"
  set ylabel "stress / q  (–)"
  set title caption noenhanced
  set key right bottom noenhanced
  if (words(gaps) > 0) {
    do for [k=1:words(gaps)/2] {
      set object k rectangle from real(word(gaps, 2*k-1)),graph 0 to real(word(gaps, 2*k)),graph 1 \
          behind fillcolor rgb "#bbbbbb"
    }
  }
  do for [k=(kind eq "gif" ? 1 : last):last] {
    set label 1 sprintf("t = %.1f µs", real(word(times, k))*1e6) at graph 0.98,0.93 right
    plot name.".dat" index k-1 using 1:4 with lines lw 1 lc rgb "#000000" title "reference", \
         name.".dat" index k-1 using 1:5 with lines lw 1 lc rgb "#000000" notitle, \
         name.".dat" index k-1 using 1:2 with lines lw 2 lc rgb "#0072B2" title "effective stress", \
         name.".dat" index k-1 using 1:3 with lines lw 2 lc rgb "#D55E00" title "pore pressure"
  }
  unset output
}
