# Error against CPU time of all groups at all levels, the best of all as a line whose corners are
# numbered and named. Data: kind (0 a group's level, 1 the best of all),curve,cpu,error,number;
# then names for readers.
set datafile separator ","
set datafile missing "nan"
total = int(curves)
named = int(front)
list = 95 + 19*named
width = 1140
height = 480 > list + 40 + 18*total ? 480 : list + 40 + 18*total
array colour[8] = ["#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", \
                   "#7F5200"]
array shape[16] = [4, 7, 9, 5, 13, 11, 6, 8, 2, 1, 3, 12, 10, 14, 15, 4]
do for [kind in "svg png pdf"] {
  if (kind eq "svg") {
    set terminal svg size width,height dynamic enhanced font "DejaVu Sans,13" background "white"
  }
  if (kind eq "png") {
    set terminal pngcairo size width,height enhanced font "DejaVu Sans,10"
  }
  if (kind eq "pdf") {
    set terminal pdfcairo size width/96.0,height/96.0 enhanced font "DejaVu Sans,9.5"
  }
  set output name.".".kind
  scale = kind eq "svg" ? 1.25 : 1.0  # sizes are in pixels there
  size10 = sprintf(",%g", 10*scale)
  size11 = sprintf(",%g", 11*scale)
  size14 = sprintf(",%g", 14*scale)
  set logscale xy
  set format "10^{%T}"
  set tics nomirror
  set grid xtics ytics linetype 1 lw 0.6 lc rgb "#cccccc"
  set lmargin at screen 0.075
  set rmargin at screen 0.50
  set tmargin at screen 1 - 60.0/height
  set bmargin at screen 1 - 425.0/height
  set xrange [real(x_low):real(x_high)]
  set yrange [real(y_low):real(y_high)]
  set xlabel "CPU time of one run (s)"
  set ylabel y_title offset 0.5,0 noenhanced
  set label 1 caption at screen 0.5, 1 - 18.0/height center font size14 noenhanced
  set label 2 subcaption at screen 0.5, 1 - 38.0/height center font size11 noenhanced
  set label 3 "on the front, from cheap to precise:" at screen 0.52, 1 - 70.0/height left \
      font size11
  do for [i=1:named] {
    set label 3+i value(sprintf("front%d", i)) at screen 0.52, 1 - (70.0 + 19*i)/height left \
        font size10 noenhanced
  }
  set key at screen 0.51, screen 1 - real(list)/height left top Left reverse noenhanced samplen 1 font size10
  plot name.".csv" skip 1 using ($1 == 1 ? $3 : NaN):4 with lines lw 7 lc rgb "#cccccc" \
         title "best of all (Pareto front)", \
       for [c=1:total] name.".csv" skip 1 using ($1 == 0 && $2 == c ? $3 : NaN):4 \
         with points pointsize 0.6 pointtype shape[(c-1)%16+1] lc rgb colour[(c-1)%8+1] \
         title value(sprintf("legend%d", c)), \
       name.".csv" skip 1 using ($1 == 1 && $5 > 0 ? $3 : NaN):4:(sprintf("%d", int($5))) \
         with labels center offset -0.9,-0.7 font size11 notitle
  unset output
}
