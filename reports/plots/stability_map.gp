# Critical Courant numbers of a study by colour. Data blocks: column, row, critical courant (-1: the
# case cannot be run); column and row of those with unstable steps below it. Labels come as words,
# three each: centre, line, text.
nr = int(rows)
nc = int(columns)
left = 40+90*int(row_lines)
below = 80+18*int(column_lines)
width = left+nc*22+110
high = 60+nr*22+below
do for [kind in kinds] {
  if (kind eq "svg") {
    set terminal svg size width,high dynamic enhanced font "DejaVu Sans,12" background "white"
  }
  if (kind eq "png") {
    set terminal pngcairo size width,high enhanced font "DejaVu Sans,9"
  }
  if (kind eq "pdf") {
    set terminal pdfcairo size (width)/96.0,(high)/96.0 enhanced font "DejaVu Sans,8.5"
  }
  set output name.".".kind
  set lmargin at screen 1.0*left/width
  set rmargin at screen 1.0*(left+nc*22)/width
  set tmargin at screen 1-60.0/high
  set bmargin at screen 1.0*below/high
  set xrange [-0.5:nc-0.5]
  set yrange [nr-0.5:-0.5]
  unset xtics
  unset ytics
  unset key
  set palette defined (0 "#440154", 0.25 "#3b528b", 0.5 "#21918c", 0.75 "#5ec962", 1 "#fde725")
  set cbrange [0:1]
  set cblabel "critical courant  (–)" offset 0.5,0
  set colorbox user origin screen 1.0*(left+nc*22+18)/width,1.0*below/high \
      size screen 18.0/width,nr*22.0/high
  set label 1 caption at screen 0.5,1-18.0/high center font ",14" noenhanced
  set label 2 "dot: some shorter step is unstable; grey: cannot be run" \
      at screen 0.5,1-40.0/high center
  set label 3 row_names at screen 14.0/width,1.0*below/high+0.5*nr*22.0/high center rotate noenhanced
  set label 4 column_names at screen 1.0*(left+0.5*nc*22)/width,14.0/high center noenhanced
  row_x(line) = -0.8-(int(row_lines)-line)*90.0/22
  # The fastest axis stands upright, next to the picture.
  upright(line) = line == int(column_lines)
  column_y(line) = nr-0.5+(upright(line) ? 0.25 : (50+(int(column_lines)-line-0.5)*18.0)/22)
  do for [k=0:words(row_labels)/3-1] {
    set label word(row_labels, 3*k+3) right noenhanced \
        at first row_x(int(word(row_labels, 3*k+2))),first real(word(row_labels, 3*k+1))
  }
  do for [k=0:words(column_labels)/3-1] {
    line = int(word(column_labels, 3*k+2))
    if (upright(line)) {
      set label word(column_labels, 3*k+3) right rotate by 90 noenhanced \
          at first real(word(column_labels, 3*k+1)),first column_y(line)
    } else {
      set label word(column_labels, 3*k+3) center noenhanced \
          at first real(word(column_labels, 3*k+1)),first column_y(line)
    }
  }
  plot name.".dat" index 0 using 1:2:($3 < 0 ? 1/0 : $3) with image pixels, \
       name.".dat" index 0 using ($3 < 0 ? $1 : 1/0):2 with points pointtype 5 pointsize 1.6 lc rgb "#bbbbbb", \
       name.".dat" index 1 using 1:2 with points pointtype 7 pointsize 0.5 lc rgb "#ffffff"
  unset label
  unset output
}
