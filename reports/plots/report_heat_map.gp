# Cells of two keys, one panel a value of a third: colour and upper line the error at the finest
# level, lower line the observed order. Data: panel,column,row,log10 error,ink (rgb),upper,lower;
# then names for readers.
set datafile separator ","
count = int(panels)
columns = int(column_count)
rows = int(row_count)
cell = columns*count > 12 ? 64 : 84
left_px = 34 + 8*int(longest_row)
width = left_px + count*(columns*cell + 22) + 95
width = width < 760 ? 760 : width
height = 160 + 40*rows
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
  size9 = sprintf(",%g", 9*scale)
  size10 = sprintf(",%g", 10*scale)
  size11 = sprintf(",%g", 11*scale)
  size14 = sprintf(",%g", 14*scale)
  set multiplot
  set palette defined (0 "#f7fbff", 0.25 "#c6dbef", 0.5 "#6baed6", 0.75 "#2171b5", 1 "#08306b")
  set cbrange [real(c_low):real(c_high)]
  set xrange [0.5:columns+0.5]
  set yrange [rows+0.5:0.5]
  set tics scale 0
  unset key
  set xlabel x_title noenhanced
  do for [panel=1:count] {
    left = (left_px + (panel-1)*(columns*cell + 22.0))/width
    set lmargin at screen left
    set rmargin at screen left + columns*cell/real(width)
    set tmargin at screen 1 - 85.0/height
    set bmargin at screen 65.0/height
    unset label
    if (panel == 1) {
      set label 1 caption at screen 0.5, 1 - 18.0/height center font size14 noenhanced
      set label 2 subcaption at screen 0.5, 1 - 38.0/height center font size11 noenhanced
    }
    set label 3 value(sprintf("title%d", panel)) at graph 0.5, screen 1 - 70.0/height center \
        noenhanced
    unset xtics
    unset ytics
    set xtics () noenhanced
    do for [i=1:columns] { set xtics add (value(sprintf("column%d", i)) i) }
    if (panel == 1) {
      set ytics () noenhanced
      do for [i=1:rows] { set ytics add (value(sprintf("row%d", i)) i) }
    }
    if (panel == count) {
      set colorbox user origin screen left + (columns*cell + 14.0)/width, screen 65.0/height \
          size screen 12.0/width, screen (height - 150.0)/height
      set cblabel c_title offset 0.5,0 font size10 noenhanced
      set cbtics () font size10
      do for [e=-12:2] {
        do for [m in "1 2 5"] {
          set cbtics add (sprintf("%g", int(m)*10.0**e) log10(int(m)*10.0**e))
        }
      }
    } else {
      unset colorbox
    }
    plot name.".csv" skip 1 using ($1 == panel ? $2 : NaN):3:($2-0.49):($2+0.49):($3-0.48):($3+0.48):4 \
           with boxxyerror fillstyle solid 1.0 noborder linecolor palette, \
         name.".csv" skip 1 using ($1 == panel ? $2 : NaN):($3-0.17):(strcol(6)):5 with labels \
           noenhanced font size10 textcolor rgb variable, \
         name.".csv" skip 1 using ($1 == panel ? $2 : NaN):($3+0.2):(strcol(7)):5 with labels \
           noenhanced font size9 textcolor rgb variable
  }
  unset multiplot
  unset output
}
