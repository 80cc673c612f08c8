#!/bin/sh
# Draws the figures of src/*/README.md. `make figures` calls it.
#
# tools/draw-figures.sh [FOLDER]    (default: models/figures)
set -eu
cd "$(dirname "$0")/.."
roberts=${ROBERTS_BUILD:-build}/roberts
folder=${1:-models/figures}
mkdir -p "$folder"

# figure NAME WIDTHxHEIGHT OPTION... MODEL
figure() {
    name=$1 size=$2
    shift 2
    "$roberts" --background white --page "$size" --margin 2 "$@" -o "$folder/$name.svg"
}

for outcome in test1-in-front test2-all-left test3-inside test3-pierced test4-two-crossings; do
    figure $outcome 50x40 --dir 3,-6,9 --hidden dashed models/tests/$outcome.off
done

cubes=models/cube-behind-cube.off
figure view-iso 50x50 --hidden dashed $cubes
figure view-cavalier 50x50 --view cavalier --hidden dashed $cubes
figure view-perspective 50x50 --eye 8,-8,7 --hidden dashed $cubes
figure view-near 50x50 --eye 8,-8,7 --near 11 --fov 40 --hidden dashed $cubes

figure draw-pattern 60x45 --hidden dashed models/stella-octangula.off
figure draw-real 60x45 --hidden dashed --dash real --style outline:color=red --style crease:color=blue \
    models/stella-octangula.off

# One line class in each figure, in red.
figure class-outline 40x40 --style outline:color=red models/interpenetrating-cubes.off
figure class-crease 40x40 --style crease:color=red models/interpenetrating-cubes.off
figure class-intersection 40x40 --style intersection:color=red models/interpenetrating-cubes.off
figure class-hidden 40x40 --hidden dashed --style hidden:color=red models/interpenetrating-cubes.off
figure class-border 40x40 --azimuth 20 --elevation 35 --style border:color=red models/shapes/moebius-strip.off

# An octahedron and its three axes, which are elements of two corners.
figure class-wire 40x40 --azimuth 20 --elevation 20 --style wire:color=red - <<END
OFF
12 11
1 0 0
-1 0 0
0 1 0
0 -1 0
0 0 1
0 0 -1
1.6 0 0
-1.6 0 0
0 1.6 0
0 -1.6 0
0 0 1.6
0 0 -1.6
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
2 6 7
2 8 9
2 10 11
END
