# gnuplot -e 'series="FOLDER"; output_file="FILE.svg"' speed_accuracy.gp
# A panel a case: error against time, of Sherd's forms and of finite elements (series written by speed_accuracy.py).
set terminal svg size 1260,860 font "DejaVu Sans,13" background "white"
set output output_file

cases = "slab_centre sphere_squeezed thick_cylinder cantilever dish_rim"
titles = "'Slab, struck in the middle' 'Sphere between two patches' 'Cylinder under inner pressure' 'Cantilever' 'Shell, struck at the rim'"
forms = "spline-linear spline-quadratic spline-cubic mls-linear mls-quadratic gmls mls-heaviside paper"
names = "'splines, linear' 'splines, quadratic' 'splines, cubic' 'MLS, linear' 'MLS, quadratic' 'GMLS' 'MLS, Heaviside' 'MLPG5 as in the paper'"
file(case, form) = sprintf("%s/%s-%s.dat", series, case, form)

# Okabe and Ito's colours; splines strong, the other forms thin.
colours = "#56B4E9 #0072B2 #009E73 #E69F00 #CC79A7 #882255 #999999 #6B4C1E"
shapes = "7 7 7 5 5 9 11 13"
open_shapes = "6 6 6 4 4 8 10 12"
width(i) = i <= 3 ? 2.2 : 1.1
mark(i) = i <= 3 ? 0.6 : 0.5
colour(i) = word(colours, i)
caption = "First blow: sampling, assembly, factor, solve and recovery\n\
at the particles and some 1300 points; further: the last two.\n\
Tets: one run of ccx, without meshing, for every blow.\n\
Error: relative L2 of the largest principal stress (sphere: of\n\
the whole stress) inside, away from the load; not shown\n\
above 200 %. All on one core."
preset_colour = "#D55E00"

set multiplot layout 2,3 margins 0.055,0.985,0.085,0.945 spacing 0.055,0.125
set logscale xy
set xrange [0.6:50000]
set yrange [0.2:200]
set xtics ("1 ms" 1, "10 ms" 10, "0.1 s" 100, "1 s" 1000, "10 s" 10000) nomirror
set ytics ("0.3 %%" 0.3, "1 %%" 1, "3 %%" 3, "10 %%" 10, "30 %%" 30, "100 %%" 100) nomirror
set border 3 lc rgb "#555555"
set grid xtics ytics lc rgb "#e4e4e4" lt 1 lw 0.7
unset key

do for [c = 1:words(cases)] {
    case = word(cases, c)
    set title word(titles, c) font ",14" offset 0,-0.4
    if (c == 1 || c == 4) { set ylabel "error of the stress" offset 1.2,0 } else { unset ylabel }
    plot for [i = words(forms):1:-1] file(case, word(forms, i)) using 2:3 with linespoints dt (4,3) lw 0.8 * width(i) \
             pt int(word(open_shapes, i)) ps mark(i) lc rgb colour(i), \
         for [i = words(forms):1:-1] file(case, word(forms, i)) using 1:3 with linespoints lw width(i) \
             pt int(word(shapes, i)) ps mark(i) lc rgb colour(i), \
         file(case, "tets-linear") using 1:3 with linespoints lw 2.2 pt 5 ps 0.6 lc rgb "black", \
         file(case, "tets-quadratic") using 1:3 with linespoints lw 2.2 pt 9 ps 0.8 lc rgb "#666666", \
         file(case, "presets") using 2:3 with points pt 7 ps 1.55 lc rgb "white", \
         file(case, "presets") using 2:3 with points pt 6 ps 1.5 lw 2 lc rgb preset_colour, \
         file(case, "presets") using 2:3:4 with labels font ",10" tc rgb preset_colour, \
         file(case, "presets") using 1:3 with points pt 7 ps 1.6 lc rgb preset_colour, \
         file(case, "presets") using 1:3:4 with labels font ",10" tc rgb "white"
}

# The legend, drawn as a panel of its own.
unset logscale; unset grid; unset border; unset xtics; unset ytics; unset ylabel
unset title
set xrange [0:1]
set yrange [0:1]
line(i) = 1 - 0.056 * i
do for [i = 1:words(forms)] {
    set label word(names, i) at 0.17,line(i) left
    set arrow from 0.02,line(i) to 0.13,line(i) nohead lw width(i) lc rgb colour(i)
    set label " " at 0.075,line(i) point pt int(word(shapes, i)) ps mark(i) lc rgb colour(i)
}
set label "finite elements (CalculiX), linear tets" at 0.17,line(9) left
set arrow from 0.02,line(9) to 0.13,line(9) nohead lw 2.2 lc rgb "black"
set label " " at 0.075,line(9) point pt 5 ps 0.6 lc rgb "black"
set label "finite elements (CalculiX), quadratic tets" at 0.17,line(10) left
set arrow from 0.02,line(10) to 0.13,line(10) nohead lw 2.2 lc rgb "#666666"
set label " " at 0.075,line(10) point pt 9 ps 0.8 lc rgb "#666666"
set label "P" at 0.075,line(0) center tc rgb "white" font ",10" front
set label " " at 0.075,line(0) point pt 7 ps 1.6 lc rgb preset_colour
set label "presets preview, game and film" at 0.17,line(0) left
set label "solid, filled: first blow on a body\ndashed, open: each further blow" at 0.02,line(11.5) left
set label caption at 0.02,line(14.0) left font ",11" tc rgb "#555555"
plot NaN
unset multiplot
