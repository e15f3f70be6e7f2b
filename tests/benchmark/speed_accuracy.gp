# gnuplot -e 'series="FOLDER"; output_file="FILE.svg"; all_forms=0' speed_accuracy.gp
# A panel a case: error against time (series written by speed_accuracy.py). Of the presets, finite elements and the
# paper's form, with the other meshless forms behind them in one colour; or, with all_forms=1, of each form by itself.
set terminal svg size 1260,860 font "DejaVu Sans,13" background "white"
set output output_file

cases = "slab_centre sphere_squeezed thick_cylinder cantilever dish_rim"
titles = "'Slab, struck in the middle' 'Sphere between two patches' 'Cylinder under inner pressure' 'Cantilever' 'Shell, struck at the rim'"
splines = "spline-linear spline-quadratic spline-cubic"
others = "mls-linear mls-quadratic gmls mls-heaviside"
forms = splines . " " . others . " paper"
names = "'splines, linear' 'splines, quadratic' 'splines, cubic' 'MLS, linear' 'MLS, quadratic' 'GMLS' 'MLS, Heaviside' 'MLPG5 as in the paper'"
file(case, form) = sprintf("%s/%s-%s.dat", series, case, form)

# Okabe and Ito's colours.
colours = "#56B4E9 #0072B2 #009E73 #E69F00 #CC79A7 #882255 #999999 #6B4C1E"
shapes = "7 7 7 5 5 9 11 13"
colour(i) = word(colours, i)
shape(i) = int(word(shapes, i))
width(i) = i <= 3 ? 2.2 : 1.1
preset_colour = "#D55E00"
paper_colour = "#6B4C1E"
behind = "#cfcfcf"
caption = "First blow: sampling, assembly, factor, solve and recovery\n\
at the particles and some 1300 points; further: the last two.\n\
Tetrahedra: one run of ccx, without meshing, for every blow.\n\
Error: relative L2 of the largest principal stress (sphere: of\n\
the whole stress) inside, away from the load; not shown\n\
above 200 %. All on one core."

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
    if (all_forms) {
        plot for [i = words(forms):1:-1] file(case, word(forms, i)) using 1:3 with linespoints lw width(i) \
                 pt shape(i) ps 0.6 lc rgb colour(i), \
             file(case, "tets-linear") using 1:3 with linespoints lw 2.2 pt 5 ps 0.6 lc rgb "black", \
             file(case, "tets-quadratic") using 1:3 with linespoints lw 2.2 pt 9 ps 0.8 lc rgb "#666666"
    } else {
        plot for [i = 1:words(others)] file(case, word(others, i)) using 1:3 with linespoints lw 1.2 \
                 pt 7 ps 0.35 lc rgb behind, \
             file(case, "paper") using 1:3 with linespoints lw 2 pt 13 ps 0.8 lc rgb paper_colour, \
             file(case, "tets-linear") using 1:3 with linespoints lw 2.2 pt 5 ps 0.6 lc rgb "black", \
             file(case, "tets-quadratic") using 1:3 with linespoints lw 2.2 pt 9 ps 0.8 lc rgb "#666666", \
             file(case, "presets") using 2:3 with lines dt (6,4) lw 1.8 lc rgb preset_colour, \
             file(case, "presets") using 1:3 with lines lw 2.2 lc rgb preset_colour, \
             file(case, "presets") using 2:3 with points pt 7 ps 1.55 lc rgb "white", \
             file(case, "presets") using 2:3 with points pt 6 ps 1.5 lw 2 lc rgb preset_colour, \
             file(case, "presets") using 2:3:4 with labels font ",10" tc rgb preset_colour, \
             file(case, "presets") using 1:3 with points pt 7 ps 1.6 lc rgb preset_colour, \
             file(case, "presets") using 1:3:4 with labels font ",10" tc rgb "white"
    }
}

# The legend, drawn as a panel of its own.
unset logscale; unset grid; unset border; unset xtics; unset ytics; unset ylabel
unset title
set xrange [0:1]
set yrange [0:1]
line(i) = 1 - 0.06 * i
entry = 0
array what[10]; array of_colour[10]; array of_shape[10]
if (all_forms) {
    do for [i = 1:words(forms)] {
        entry = entry + 1
        what[entry] = word(names, i); of_colour[entry] = colour(i); of_shape[entry] = shape(i)
    }
} else {
    set label "Sherd, first blow: preview, game, film" at 0.17,line(0) left
    set arrow from 0.02,line(0) to 0.13,line(0) nohead lw 2.2 lc rgb preset_colour
    set label "G" at 0.075,line(0) center tc rgb "white" font ",10" front
    set label " " at 0.075,line(0) point pt 7 ps 1.6 lc rgb preset_colour
    set label "Sherd, each further blow" at 0.17,line(1.1) left
    set arrow from 0.02,line(1.1) to 0.052,line(1.1) nohead dt (6,4) lw 1.8 lc rgb preset_colour
    set arrow from 0.098,line(1.1) to 0.13,line(1.1) nohead dt (6,4) lw 1.8 lc rgb preset_colour
    set label "G" at 0.075,line(1.1) center tc rgb preset_colour font ",10" front
    set label " " at 0.075,line(1.1) point pt 6 ps 1.5 lw 2 lc rgb preset_colour
    entry = 2
}
if (!all_forms) {
    entry = entry + 1
    what[entry] = "MLPG5 as in the paper"; of_colour[entry] = paper_colour; of_shape[entry] = 13
}
entry = entry + 1
what[entry] = "finite elements (CalculiX), linear tetrahedra"; of_colour[entry] = "black"; of_shape[entry] = 5
entry = entry + 1
what[entry] = "finite elements, quadratic tetrahedra"; of_colour[entry] = "#666666"; of_shape[entry] = 9
if (!all_forms) {
    entry = entry + 1
    what[entry] = "other meshless forms: MLS, GMLS"; of_colour[entry] = behind; of_shape[entry] = 7
}
above = all_forms ? 1 : 0.8
do for [i = (all_forms ? 1 : 3):entry] {
    set label what[i] at 0.17,line(i - above) left
    set arrow from 0.02,line(i - above) to 0.13,line(i - above) nohead lw 2.2 lc rgb of_colour[i]
    set label " " at 0.075,line(i - above) point pt of_shape[i] ps 0.7 lc rgb of_colour[i]
}
if (all_forms) set label "Time: first blow on a body." at 0.02,line(10.6) left
set label caption at 0.02,line(all_forms ? 12.2 : 7.4) left font ",11" tc rgb "#555555"
plot NaN
unset multiplot
