# Two fields over x and t as colours (top) and their errors (bottom), with the ways of the fast wave
# (full line) and of the slow one (dashed). Data blocks: x, t, stress, pressure, log10 of their
# errors, an empty line between times; then the ways of either wave as pieces of lines.
do for [kind in kinds] {
  if (kind eq "svg") {
    set terminal svg size 960,760 dynamic enhanced font "DejaVu Sans,13" background "white"
  }
  if (kind eq "png") {
    set terminal pngcairo size 960,760 enhanced font "DejaVu Sans,10"
  }
  if (kind eq "pdf") {
    set terminal pdfcairo size (960)/96.0,(760)/96.0 enhanced font "DejaVu Sans,9.5"
  }
  set output name.".".kind
  scale = kind eq "svg" ? 1.25 : 1.0  # sizes are in pixels there
  set multiplot
  set xrange [0:real(x_end)]
  set yrange [0:real(t_end)*1e6]
  set tics out nomirror
  set style fill solid 1.0 noborder
  unset key
  do for [panel=0:3] {
    row = panel/2
    side = panel%2
    set lmargin at screen 0.075+0.48*side
    set rmargin at screen 0.415+0.48*side
    set tmargin at screen 0.895-0.46*row
    set bmargin at screen 0.545-0.46*row
    unset label
    unset object
    if (panel == 0) {
      set label 1 caption at screen 0.5,0.972 center font sprintf(",%g", 12*scale) noenhanced
      set label 2 "full line: fast wave (P1), dashed: slow wave (P2)" at screen 0.5,0.938 center
    }
    set label 3 (row == 0 ? (side == 0 ? "effective stress" : "pore pressure") \
                          : (side == 0 ? "error of effective stress" : "error of pore pressure")) \
        at graph 0.5,1.045 center
    if (words(gaps) > 0) {
      do for [k=1:words(gaps)/2] {
        set object k rectangle from real(word(gaps, 2*k-1)),graph 0 to real(word(gaps, 2*k)),graph 1 \
            front fillstyle empty border lc rgb "#555555"
      }
    }
    set ylabel (side == 0 ? "t  (µs)" : "") offset 1.5,0
    set xlabel (row == 1 ? "x  (m)" : "")
    if (row == 0) {
      high = real(side == 0 ? stress_high : pressure_high)
      set palette defined (-1 "#2166ac", -0.5 "#92c5de", 0 "#f7f7f7", 0.5 "#f4a582", 1 "#b2182b")
      set cbrange [-high:high]
      set cblabel (side == 0 ? "σ′/q  (–)" : "p/q  (–)") offset -0.5,0
    } else {
      set palette defined (0 "#440154", 0.25 "#3b528b", 0.5 "#21918c", 0.75 "#5ec962", 1 "#fde725")
      set cbrange [real(error_low):0]
      set cblabel "log_{10} |error/q|  (–)" offset 0.7,0
    }
    set colorbox user origin graph 1.03,0 size graph 0.04,1
    plot name.".dat" index 0 using 1:($2*1e6):(column(3+2*(panel/2)+panel%2)) with image, \
         name.".dat" index 1 using 1:($2*1e6) with lines lw 1.2 lc rgb (row == 0 ? "#000000" : "#ffffff"), \
         name.".dat" index 2 using 1:($2*1e6) with lines lw 1.2 dashtype 2 \
             lc rgb (row == 0 ? "#000000" : "#ffffff")
  }
  unset multiplot
  unset output
}
