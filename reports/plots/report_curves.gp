# Curves with a band in panels side by side, their legends below. Data: panel,curve,x,y,low,high;
# then names for readers. Texts: titleP of panel P, legend_P_C of its curve C,
# floor_P_C (a height, or empty), triangleP ("h error order", or empty), x_tics.
set datafile separator ","
set datafile missing "nan"
count = int(panels)
total = int(curves)
shown = int(legend_lines)
width = count == 1 ? 720 : 990
height = 420 + 18*shown
array colour[8] = ["#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", \
                   "#7F5200"]
array shape[8] = [4, 7, 9, 5, 13, 11, 6, 8]
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
  set multiplot
  set logscale xy
  set grid xtics ytics linetype 1 lw 0.6 lc rgb "#cccccc"
  set xrange [real(x_low):real(x_high)]
  set yrange [real(y_low):real(y_high)]
  set tics nomirror
  set xtics () font size10
  do for [i=1:words(x_tics)] { set xtics add (word(x_tics, i) real(word(x_tics, i))) }
  step = 900.0/count/width
  do for [panel=1:count] {
    if (y_power eq "yes") {
      set format y (panel == 1 ? "10^{%T}" : "")
    } else {
      set ytics ()
      do for [e=-3:6] {
        do for [m in "1 2 5"] {
          tic = int(m)*10.0**e
          set ytics add ((panel == 1 ? sprintf("%g", tic) : "") tic)
        }
      }
    }
    left = 75.0/width + (panel-1)*step
    right = count == 1 ? 0.97 : left + step - 18.0/width
    set lmargin at screen left
    set rmargin at screen right
    set tmargin at screen 1 - 68.0/height
    set bmargin at screen 1 - 338.0/height
    unset label
    unset arrow
    if (panel == 1) {
      set label 1 caption at screen 0.5, 1 - 18.0/height center font size14 noenhanced
      set label 2 subcaption at screen 0.5, 1 - 39.0/height center font size11 noenhanced
      set ylabel y_title offset 0.5,0 noenhanced
    } else {
      unset ylabel
    }
    set xlabel x_title noenhanced
    set label 3 value(sprintf("title%d", panel)) at graph 0.5,1.04 center noenhanced
    triangle = value(sprintf("triangle%d", panel))
    if (triangle ne "") {
      h0 = real(word(triangle, 1))
      e0 = real(word(triangle, 2))
      p0 = real(word(triangle, 3))
      set arrow 1 from h0,e0 to 2*h0,e0 nohead lw 1.5 lc rgb "#444444" front
      set arrow 2 from 2*h0,e0 to 2*h0,e0*2**p0 nohead lw 1.5 lc rgb "#444444" front
      set arrow 3 from h0,e0 to 2*h0,e0*2**p0 nohead lw 1.5 lc rgb "#444444" front
      set label 4 word(triangle, 3) at 2.15*h0,e0*2**(0.5*p0) textcolor rgb "#222222" front
    }
    do for [c=1:total] {
      floor = value(sprintf("floor_%d_%d", panel, c))
      if (floor ne "") {
          set arrow 10+c from graph 0,first real(floor) to graph 1,first real(floor) nohead \
            dashtype 3 lw 1.5 lc rgb colour[(c-1)%8+1]
      }
    }
    set key at screen left + (count == 1 ? 0.02 : -8.0/width), screen 1 - 398.0/height left top \
        Left reverse noenhanced samplen 2.5 font size10
    plot for [c=1:total] name.".csv" skip 1 \
           using ($1 == panel && $2 == c ? $3 : NaN):5:6 with filledcurves \
           fillcolor rgb colour[(c-1)%8+1] \
           fillstyle transparent solid 0.15 noborder notitle, \
         for [c=1:total] name.".csv" skip 1 using ($1 == panel && $2 == c ? $3 : NaN):4 \
           with linespoints lw 1.6 pointsize 0.7 \
           dashtype int(c > 8 ? 2 : 1) \
           pointtype shape[(c-1)%8+1] \
           lc rgb colour[(c-1)%8+1] \
           title value(sprintf("legend_%d_%d", panel, c))
  }
  unset multiplot
  unset output
}
