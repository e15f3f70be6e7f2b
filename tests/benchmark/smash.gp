# gnuplot -e 'series="FOLDER"; output_file="FILE.svg"' smash.gp
# What the steps of the smash take (smash_RATE.dat and smash_RATE_whole.dat, written by smash --steps).
set terminal svg size 1260,520 font "DejaVu Sans,13" background "white"
set output output_file
rates = "60 240"

set multiplot layout 1,2 margins 0.065,0.985,0.13,0.91 spacing 0.07
set border 3 lc rgb "#555555"
set grid ytics lc rgb "#e4e4e4" lt 1 lw 0.7
set logscale y
set yrange [0.3:2000]
set ytics ("1 ms" 1, "10 ms" 10, "100 ms" 100, "1 s" 1000) nomirror
set xrange [0:2]
set xtics 0.5 nomirror
set xlabel "simulated time, s" offset 0,0.3
set key top right reverse Left samplen 1.5 spacing 1.2

do for [r = 1:words(rates)] {
    rate = word(rates, r)
    frame_ms = 1000.0 / rate
    set title "30 cups and a ball, " . rate . " steps a second: time of each step" font ",14" offset 0,-0.4
    plot sprintf("%s/smash_%s_whole.dat", series, rate) using ($1 / rate):2 with lines lw 1.4 lc rgb "#999999" title "every blow decided in its step", \
         sprintf("%s/smash_%s.dat", series, rate) using ($1 / rate):2 with lines lw 1.8 lc rgb "#0072B2" title "with the budget of the defaults", \
         sprintf("%s/smash_%s.dat", series, rate) using ($1 / rate):3 with lines lw 1.2 lc rgb "#009E73" title "of which Bullet's own", \
         sprintf("%s/smash_%s.dat", series, rate) using ($1 / rate):4 with lines lw 1.2 lc rgb "#CC79A7" title "plain Bullet, the same bodies", \
         frame_ms with lines dt 2 lw 1.4 lc rgb "#D55E00" title sprintf("%.1f ms: the step's own length", frame_ms)
}
unset multiplot
