# gnuplot -e 'series="FOLDER"; output_file="FILE.svg"' resampling.gp
# Particles in a section of a sphere that is squeezed between two small patches (data written by resampling.py).
set terminal svg size 1260,430 font "DejaVu Sans,13" background "white"
set output output_file

set multiplot layout 1,3 margins 0.01,0.9,0.03,0.9 spacing 0.01,0
set size ratio -1
unset border
unset tics
set palette defined (0 "#fff7bc", 0.35 "#fec44f", 0.65 "#d95f0e", 1 "#67000d")
set logscale cb
set cbrange [1e5:2e7]
set style fill solid noborder
set xrange [-0.51:0.51]
set yrange [-0.51:0.51]
unset colorbox
do for [rounds in "0 1 2"] {
    if (rounds eq "2") {
        set colorbox user origin 0.92,0.1 size 0.014,0.75
        set format cb "%.0s %cPa"
        set cbtics nomirror
    }
    set title (rounds eq "0" ? "no resampling" : rounds eq "1" ? "one round" : "two rounds") font ",14"
    plot sprintf("%s/resampling-%s.dat", series, rounds) using 1:2:(0.42 * $3):($4 > 1e5 ? $4 : 1e5) \
        with circles fillcolor palette notitle
}
unset multiplot
