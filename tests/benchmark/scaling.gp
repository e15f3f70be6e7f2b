# gnuplot -e 'series="FOLDER"; output_file="FILE.svg"' scaling.gp
# How assembly, factor and its memory grow with the particles of the slab (series written by scaling.py).
set terminal svg size 1260,430 font "DejaVu Sans,13" background "white"
set output output_file

file(basis) = sprintf("%s/scaling-%s.dat", series, basis)
linear = "#E69F00"
quadratic = "#0072B2"

set multiplot layout 1,3 margins 0.06,0.985,0.15,0.89 spacing 0.07,0
set logscale xy
set xrange [700:45000]
set xtics ("1 000" 1000, "3 000" 3000, "10 000" 10000, "30 000" 30000) nomirror
set ytics nomirror
set border 3 lc rgb "#555555"
set grid xtics ytics lc rgb "#e4e4e4" lt 1 lw 0.7
set key bottom left reverse Left samplen 2.5
set xlabel "particles"

set title "Assembly per particle" font ",14"
set yrange [0.3:30]
set ytics ("1 µs" 1, "3 µs" 3, "10 µs" 10, "30 µs" 30, "100 µs" 100)
plot file("quadratic") using 1:(1000 * $3 / $1) with linespoints lw 2.2 pt 7 ps 0.7 lc rgb quadratic title "splines, quadratic", \
     file("linear") using 1:(1000 * $3 / $1) with linespoints lw 2.2 pt 5 ps 0.6 lc rgb linear title "splines, linear"

unset key
set title "Factor, once a body (filled); solve, each blow (open)"
set yrange [0.5:100000]
set ytics ("1 ms" 1, "10 ms" 10, "0.1 s" 100, "1 s" 1000, "10 s" 10000, "100 s" 100000)
plot file("quadratic") using 1:4 with linespoints lw 2.2 pt 7 ps 0.7 lc rgb quadratic, \
     file("linear") using 1:4 with linespoints lw 2.2 pt 5 ps 0.6 lc rgb linear, \
     file("quadratic") using 1:5 with linespoints lw 2.2 dt (4,3) pt 6 ps 0.7 lc rgb quadratic, \
     file("linear") using 1:5 with linespoints lw 2.2 dt (4,3) pt 4 ps 0.6 lc rgb linear

set title "Memory of the factor"
set yrange [1:10000]
set ytics ("1 MB" 1, "10 MB" 10, "100 MB" 100, "1 GB" 1000, "10 GB" 10000)
plot file("quadratic") using 1:($6 / 1e6) with linespoints lw 2.2 pt 7 ps 0.7 lc rgb quadratic, \
     file("linear") using 1:($6 / 1e6) with linespoints lw 2.2 pt 5 ps 0.6 lc rgb linear
unset multiplot
