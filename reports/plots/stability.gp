# Stability of a scene: growth a step (less 1) against the Courant number, and the fastest-growing
# mode against x, velocities and stresses. Data blocks: courant and growth; x and both velocities;
# x and both stresses. Without a mode only the first.
panels = mode eq "" ? 1 : 3
do for [kind in "svg png"] {
  if (kind eq "svg") {
    set terminal svg size 960,110+panels*230 dynamic enhanced font "DejaVu Sans,13" background "white"
  } else {
    set terminal pngcairo size 960,110+panels*230 enhanced font "DejaVu Sans,10"
  }
  set output name.".".kind
  set multiplot
  set grid lc rgb "#dddddd"
  set lmargin at screen 0.095
  set rmargin at screen 0.975
  pixel = 1.0/(110+panels*230)
  set label 1 caption at screen 0.5,1-18*pixel center font ",15" noenhanced
  set tmargin at screen 1-50*pixel
  set bmargin at screen 1-220*pixel
  set logscale y
  set format y "10^{%T}"
  set xrange [0:1.04*real(highest)]
  set yrange [5e-8:10]
  set xlabel "courant, c_1 Δt/h  (–)" offset 0,0.4
  set ylabel "growth a step − 1  (–)" offset 1,0
  set arrow 1 from 0,real(limit) to 1.04*real(highest),real(limit) nohead dashtype 3 lc rgb "#555555"
  set label 2 "limit" at graph 0.993,first 1.8*real(limit) right
  set arrow 2 from real(requested),graph 0 to real(requested),graph 1 nohead dashtype 2 lw 1.5 lc rgb "#009E73"
  if (real(critical) > 0) {
    set arrow 3 from real(critical),graph 0 to real(critical),graph 1 nohead lw 1.5 lc rgb "#D55E00"
  }
  set key at graph 0.02,0.95 left top Left reverse samplen 2
  plot name.".dat" index 0 using 1:2 with linespoints lw 1.4 pointtype 7 pointsize 0.5 \
           lc rgb "#0072B2" title "growth (10^{-7}: none)", \
       NaN with lines dashtype 2 lw 1.5 lc rgb "#009E73" title "step of the run", \
       NaN with lines lw 1.5 lc rgb "#D55E00" title "critical step"
  unset label
  unset arrow
  unset logscale y
  set format y "%g"
  if (panels == 3) {
    set xrange [0:real(x_end)]
    set yrange [-1.15:1.15]
    set label 1 mode at graph 0,1.1 left noenhanced
    set tmargin at screen 1-310*pixel
    set bmargin at screen 1-490*pixel
    unset xlabel
    set ylabel "velocity  (any unit)"
    set key at graph 1.0,1.19 right top horizontal Right noreverse samplen 2
    plot name.".dat" index 1 using 1:2 with linespoints lw 1.2 pointtype 7 pointsize 0.35 \
             lc rgb "#0072B2" title "solid, at nodes", \
         name.".dat" index 1 using 1:3 with linespoints lw 1.2 pointtype 9 pointsize 0.4 \
             lc rgb "#D55E00" title "fluid, at nodes"
    unset label
    set tmargin at screen 1-540*pixel
    set bmargin at screen 1-740*pixel
    set xlabel "x  (m)" offset 0,0.3
    set ylabel "stress / largest  (–)"
    set key at graph 1.0,1.17 right top horizontal Right noreverse samplen 2
    plot name.".dat" index 2 using 1:2 with linespoints lw 1.2 pointtype 7 pointsize 0.35 \
             lc rgb "#0072B2" title "effective stress, of cells", \
         name.".dat" index 2 using 1:3 with linespoints lw 1.2 pointtype 9 pointsize 0.4 \
             lc rgb "#D55E00" title "pore pressure, of cells"
  }
  unset multiplot
  unset output
}
