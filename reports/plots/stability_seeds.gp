# Share of the seeds whose critical Courant number is at most x. One data block a curve: critical
# courant, %.
array colour[8] = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#000000", "#56B4E9", \
                   "#7F5200"]
total = int(count)
do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 860,480+22*total dynamic enhanced font "DejaVu Sans,13" background "white"
  } else {
    set terminal pngcairo size 860,480+22*total enhanced font "DejaVu Sans,10"
  }
  height = 480.0+22*total
  set output name.".".kind
  set lmargin at screen 0.09
  set rmargin at screen 0.97
  set tmargin at screen 1-60/height
  set bmargin at screen 1-415/height
  set grid lc rgb "#dddddd"
  set tics nomirror
  set logscale y
  set xrange [real(lowest):real(highest)]
  set yrange [real(least):100]
  set format y "%g"
  set xlabel "critical courant  (–)"
  set ylabel "seeds with at most that limit  (%)"
  set label 1 caption at screen 0.5,1-20/height center font ",15" noenhanced
  set label 2 subcaption at screen 0.5,1-43/height center noenhanced
  set key at screen 0.09,1-462/height left top Left reverse noenhanced samplen 3 maxcols 1
  plot for [k=1:total] name.".dat" index k-1 using 1:($2 > 0 ? $2 : 0.5*real(least)) with steps lw 2 \
       dashtype int((k-1)%5+1) lc rgb colour[(k-1)%8+1] title value(sprintf("curve%d", k))
  unset output
}
