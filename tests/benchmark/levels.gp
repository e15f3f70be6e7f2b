# gnuplot -e 'series="FOLDER"; output_file="FILE.svg"' levels.gp
# Cost against accuracy of the levels that decide a blow, on five bodies (levels.dat, written by levels_benchmark).
set terminal svg size 1260,560 font "DejaVu Sans,13" background "white"
set output output_file

levels = "gate reduced preview game film"
names = "'gate' 'reduced model' 'preview' 'game' 'film (truth)'"
colours = "#56B4E9 #0072B2 #E69F00 #009E73 #999999"
bodies = "slab block cup dish aeroplane"
shapes = "5 7 9 11 13"
data = series . "/levels.dat"
pick(level, body, column) = sprintf("< awk '$1 == \"%s\" && $2 == \"%s\" {print $3, $%d, $6}' %s", body, level, column, data)

set multiplot layout 1,2 margins 0.06,0.985,0.2,0.92 spacing 0.075
set logscale x
set xrange [0.005:20000]
set xtics ("0.01 ms" 0.01, "0.1 ms" 0.1, "1 ms" 1, "10 ms" 10, "0.1 s" 100, "1 s" 1000, "10 s" 10000) nomirror
set border 3 lc rgb "#555555"
set grid xtics ytics lc rgb "#e4e4e4" lt 1 lw 0.7
set xlabel "time of a further blow, one core" offset 0,0.3
unset key

do for [panel = 1:2] {
    column = panel == 1 ? 5 : 4
    set title (panel == 1 ? "Wrong decisions" : "Error of the largest stress") font ",14" offset 0,-0.4
    set format y "%g %%"
    set yrange [panel == 1 ? -0.3 : -0.6 : (panel == 1 ? 3 : 6) < *]
    set ytics 0,(panel == 1 ? 0.5 : 1) nomirror
    set key top left vertical Left reverse samplen 0.5 spacing 1.2
    if (panel == 1) {
        set label 1 "Of the blows that hold, the gate decides the share beside its marks; the others go on to the reduced model. " . \
            "These two are held against the full solve of their own body, the others against film." \
            at screen 0.06,0.05 font ",11" tc rgb "#555555"
    } else {
        unset label 1
    }
    if (panel == 1) {
        plot for [l = 1:words(levels)] for [b = 1:words(bodies)] pick(word(levels, l), word(bodies, b), column) \
                 using 1:2 with points pt int(word(shapes, b)) ps 1.1 lc rgb word(colours, l) notitle, \
             for [b = 1:words(bodies)] pick("gate", word(bodies, b), column) \
                 using (0.04):(0.25 * (b - 1)):(sprintf("%s %.0f %%", word(bodies, b), $3)) \
                 with labels left font ",10" tc rgb "#2B8CC4" notitle, \
             for [l = 1:words(levels)] NaN with points pt 7 ps 1.1 lc rgb word(colours, l) title word(names, l)
    } else {
        plot for [l = 2:words(levels)] for [b = 1:words(bodies)] pick(word(levels, l), word(bodies, b), column) \
                 using 1:2 with points pt int(word(shapes, b)) ps 1.1 lc rgb word(colours, l) notitle, \
             for [b = 1:words(bodies)] NaN with points pt int(word(shapes, b)) ps 1.1 lc rgb "#555555" title word(bodies, b)
    }
}
unset multiplot
