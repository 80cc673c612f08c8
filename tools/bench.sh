#!/bin/sh
# Measures the program: tools/bench.sh [PART]...    (the first four unless given; `make bench` builds first)
#
#   scenes        lattice, city, wall and plates of a thousand solids to a million, and ../shared/scenes if present:
#                 each stage, memory, growth; drawn as SVG; checked by --verify; read by strtod(); two threads
#                 compared with one
#   worst         scenes that are hard, each for one reason
#   meshes        meshes of up to 350,000 triangles: scans, balls, land, stars; balls and loose triangles that cross;
#                 what is seen of each face (--regions)
#   instructions  instructions executed, counted by callgrind, compared with tools/bench-baseline.txt
#   baseline      the same, and rewrites that file
#   all-meshes    the meshes, to 1.4 million triangles (`make bench-meshes`)
#   tables        measures nothing: prints the tables of the last measurement, even if it was interrupted
#
# Prints tables, and writes the same figures, tab-separated, to build/bench/. A row is the run with the median CPU time,
# of nine runs for a thousand solids down to three for a million; of a third as many with --verify, of one as SVG.
# make-models writes the scenes there. They are kept, except those of a million solids (up to 0.5 GB each).
#
# BENCH_MAX       most solids or triangles in a scene (1e7: no bound); a small value is quick: BENCH_MAX=1e5
# BENCH_LIMIT     seconds after which a run is stopped, and larger scenes of its kind are skipped (100; needs timeout)
# ROBERTS_BUILD   the build to measure (build)
# ROBERTS_SHARED  folder with scenes/ and models/ from elsewhere (../shared)
set -u
LC_ALL=C
export LC_ALL

build=${ROBERTS_BUILD:-build}
shared=${ROBERTS_SHARED:-../shared}
roberts=$build/roberts
out=$build/bench
baseline=tools/bench-baseline.txt
limit=${BENCH_LIMIT:-100}
most=$(awk -v n="${BENCH_MAX:-1e7}" 'BEGIN { printf "%d", n }')
general='--dir .31,.47,.83' # no face of our scenes is edge-on, no two corners lie behind one another

tab=$(printf '\t')
counts='solids culled_solids vertices faces front_faces edges surviving_edges drawn_edges segments grid peak_memory_kb
    pairs test1_visible test2_visible test3_visible test3_invisible test4 covered refined'
stages='read solids view grid hide regions verify draw total'

# Not ulimit -t: with it, Linux measures CPU time in ticks of 4 ms.
guard=
! command -v timeout >/dev/null 2>&1 || guard="timeout $limit"

say() {
    echo "bench: $*" >&2
}

die() {
    say "$*"
    exit 1
}

# ---- scenes ----------------------------------------------------------------------------------------------------------

large= # the scene of a million solids that is there, if any; the next one takes its place

# scene FAMILY N: sets `file` to that scene, and makes it if it is missing or the generator is newer
scene() {
    file=$out/$1-$2.off
    rm -f "$large"
    if [ ! -s "$file" ] || [ -n "$(find tools/make-models.c tools/models -newer "$file")" ]; then
        "$build/tools/make-models" "$1" "$2" >"$out/scene.part" || die "make-models $1 $2 failed"
        mv "$out/scene.part" "$file"
    fi
}

# argument FAMILY SIZE: prints the generator's N for about SIZE solids, or triangles of a mesh
argument() {
    case $1-$2 in
    lattice-1000) echo 10 ;;
    lattice-10000) echo 22 ;;
    lattice-100000) echo 46 ;;
    lattice-1000000) echo 100 ;;
    city-1000 | plain-1000) echo 16 ;;
    city-10000 | plain-10000) echo 50 ;;
    city-100000 | plain-100000) echo 158 ;;
    city-1000000 | plain-1000000) echo 500 ;;
    stars-10000) echo 6 ;;
    stars-100000) echo 13 ;;
    stars-1000000) echo 29 ;;
    *) echo "$2" ;;
    esac
}

runs_for() {
    if [ "$1" -le 2000 ]; then
        echo 9
    elif [ "$1" -le 20000 ]; then
        echo 5
    else
        echo 3
    fi
}

# moved X,Y,Z FILE: writes the OFF text with its vertices moved
moved() {
    awk -v by="$1" -v OFMT=%.17g 'BEGIN { split(by, d, ",") }
        /^[ \t]*(#|$)/ || !keyword { keyword = keyword || /^OFF/; print; next }
        !vertices { vertices = $1; print; next }
        seen < vertices { seen++; print $1 + d[1], $2 + d[2], $3 + d[3]; next }
        { print }' "$2"
}

# ---- runs ------------------------------------------------------------------------------------------------------------

# Prints the figures of a JSON of --stats, read from standard input, as a row.
figures() {
    awk -v counts="$counts" -v stages="$stages" '
        function count(key) {
            if (!match($0, "\"" key "\":[0-9]+"))
                return "-"
            return substr($0, RSTART + length(key) + 3, RLENGTH - length(key) - 3)
        }
        function seconds(stage, clock,   of) {
            if (!match($0, "\"" stage "\":[{][^}]*"))
                return "-"
            of = substr($0, RSTART, RLENGTH)
            if (!match(of, "\"" clock "\":[0-9.]+"))
                return "-"
            return substr(of, RSTART + length(clock) + 3, RLENGTH - length(clock) - 3)
        }
        /^[{]/ {
            row = ""
            for (i = split(counts, key, " "); i >= 1; i--)
                row = count(key[i]) "\t" row
            n = split(stages, stage, " ")
            for (i = 1; i <= n; i++)
                row = row seconds(stage[i], "cpu") "\t"
            for (i = 1; i <= n; i++)
                row = row seconds(stage[i], "wall") (i < n ? "\t" : "")
            print row
        }'
}

head_line() {
    printf 'kind\tscene\toptions\tthreads\tformat\truns\tbytes'
    printf '\t%s' $counts
    for stage in $stages; do printf '\t%s_cpu' "$stage"; done
    for stage in $stages; do printf '\t%s_wall' "$stage"; done
    printf '\tleast_total_cpu\n'
}

# measure TABLE KIND SCENE RUNS THREADS FORMAT [OPTION|FILE]...: adds the row of the median run to
# build/bench/TABLE.tsv; fails if the program does
measure() {
    table=$1 kind=$2 name=$3 runs=$4 threads=$5 format=$6
    shift 6
    bytes=0 options=
    for word in "$@"; do
        if [ -f "$word" ]; then
            bytes=$((bytes + $(wc -c <"$word")))
        else
            options="$options${options:+ }$word"
        fi
    done
    say "$name $options, $threads thread(s), $format, $bytes bytes, $runs run(s)"
    i=0
    : >"$out/runs"
    while [ $i -lt "$runs" ]; do
        $guard "$roberts" -q --stats=json --threads "$threads" -f "$format" -o /dev/null "$@" 2>"$out/stats"
        status=$?
        if [ $status -ne 0 ]; then
            [ $status -eq 124 ] && why="more than $limit seconds" || why=$(head -n 1 "$out/stats")
            say "gave up $name, $bytes bytes: $why"
            printf '%s\t%s\t%s\t%s\t%s\t0\t%s\n' "$kind" "$name" "$options" "$threads" "$format" "$bytes" \
                >>"$out/$table.tsv"
            return 1
        fi
        figures <"$out/stats" >>"$out/runs"
        i=$((i + 1))
    done
    total=$(head_line | awk '{ for (i = 1; i <= NF; i++) if ($i == "total_cpu") print i - 7 }')
    sort -t "$tab" -k "$total,${total}n" "$out/runs" |
        awk -F '\t' -v before="$kind$tab$name$tab$options$tab$threads$tab$format$tab$runs$tab$bytes" -v total="$total" '
            { row[NR] = $0 }
            NR == 1 { least = $total }
            END { print before "\t" row[int((NR + 1) / 2)] "\t" least }' >>"$out/$table.tsv"
}

# ---- parts -----------------------------------------------------------------------------------------------------------

# one_scene NAME FILE RUNS: makes all measurements of a scene
one_scene() {
    measure scenes stages "$1" "$3" 1 null $general "$2" || return
    measure scenes draw "$1" 1 1 svg --order none $general "$2"
    measure scenes plot "$1" 1 1 svg $general "$2"
    measure scenes threads "$1" "$3" 2 null $general "$2"
    measure scenes verify "$1" $((($3 + 2) / 3)) 1 null --verify $general "$2"
    row=$(taskset -c 0 "$build/tools/bench-read" "$2" "$3") && printf '%s\t%s\n' "$1" "$row" >>"$out/read.tsv"
}

scenes() {
    head_line >"$out/scenes.tsv"
    printf 'scene\tbytes\tnumbers\tread_cpu\tstrtod_cpu\ttimes\n' >"$out/read.tsv"
    for family in lattice city wall plates; do
        for size in 1000 10000 100000 1000000; do
            [ $size -le "$most" ] || break
            scene $family "$(argument $family $size)"
            [ $size -lt 1000000 ] || large=$file
            one_scene $family "$file" "$(runs_for $size)" || break
        done
    done
    if [ -d "$shared/scenes" ]; then
        for file in "$shared"/scenes/*.off; do
            one_scene "$(basename "$file" .off)" "$file" 5
        done
    else
        say "no $shared/scenes: left out"
    fi
}

# grow NAME FAMILY "SIZES" OPTION...: measures a hard scene of increasing size
grow() {
    name=$1 family=$2 sizes=$3
    shift 3
    for size in $sizes; do
        [ "$size" -le "$most" ] || break
        scene "$family" "$(argument "$family" "$size")"
        [ "$size" -lt 1000000 ] || large=$file
        measure worst stages "$name" "$(runs_for "$size")" 1 null "$@" "$file" || break
    done
}

# two_of NAME FILE X,Y,Z OPTION...: measures a model together with a moved copy
two_of() {
    name=$1 first=$2 by=$3
    shift 3
    moved "$by" "$first" >"$out/moved.off"
    measure worst stages "$name" 3 1 null "$@" "$first" "$out/moved.off"
    status=$?
    rm -f "$out/moved.off"
    return $status
}

worst() {
    head_line >"$out/worst.tsv"
    thousands='1000 10000 100000'
    grow 'stack: all in one cell' stack "$thousands" --view top
    grow 'stack, by an eye along it' stack "$thousands" --eye 100,0,150000
    grow 'ground: one face hides all' ground "$thousands 1000000" --view top
    grow 'ground: all before one face' ground "$thousands 1000000" --view bottom
    grow 'copies: all at one place' copies "$thousands" $general
    grow 'coins: a hundred of many corners' coins '100 1000 10000' $general
    grow 'coins: a hundred of many corners' coins '100 1000 10000' --view top
    grow 'disc: as many corners as solids under it' disc "$thousands" --view top
    grow 'disc: as many corners as solids under it' disc "$thousands" $general
    grow 'parts: a straight border in many' parts "$thousands" --view top
    grow 'fans: one behind the tip of the other' fans '1000 10000 100000' --view top --all-edges
    grow 'gear: two faces of as many corners as faces' gear '500 1000 2000' --view iso
    grow 'layers: ten boards with winding borders' layers '1000 4000 16000' $general
    grow 'roof: a folded sheet, hidden lines too' roof '5000 10000 20000' --view iso --hidden dashed
    grow 'deck: planks flush on joists, as one body' deck '5000 10000 20000' --view iso --union
    grow 'needles: long and thin' needles '100 300 1000 3000' --view top
    grow 'lattice, along an axis: deeper as it grows' lattice "$thousands" --view front
    grow 'wall, steeply from above: deeper as it grows' wall "$thousands" --dir .01,.02,1
    grow 'wall, edge-on' wall "$thousands" --view front
    grow 'wall, edge-on, its end' wall "$thousands" --view right
    grow 'wall, edge-on, from above' wall "$thousands" --view top
    grow 'city, edge-on' city "$thousands" --view front
    grow 'city, edge-on, from above' city "$thousands" --view top
    grow 'city, corner behind corner' city "$thousands" --view iso
    grow 'boards: long planks seen aslant' boards '4000 8000 16000' --view iso
    grow 'diagonal: long sticks, all aslant' diagonal '2000 4000 8000' --view top
    grow 'crowd: nearly all in one spot' crowd '10000 40000 100000' $general
    grow 'galaxy: all sizes' galaxy '10000 40000 100000' $general
    grow 'street: an eye in a city, hidden lines too' city '10000 100000' --eye 14,14.5,1.75 --look-at 400,410,1.75 \
        --fov 90 --hidden dashed
    grow 'lattice, by an eye in it' lattice '10000 100000' --eye 5,5.02,5.01 --look-at 30,31,32 --fov 90
    grow 'sheets, seen nearly along' sheets '4000 8000 16000' --dir .31,.47,.083
    grow 'floors: each peeps out' floors '5000 10000 20000' --view top
    grow 'shells: each peeps out' shells '5000 10000 20000' --view top
    grow 'posts: edges seen nearly end-on' posts '20000 200000' --dir .0000002,.0000003,1
    grow 'city on a wide plate' plain '10000 100000' $general
    grow 'spines in all directions' spines '4000 8000 16000' $general
    grow 'ball: one solid' sphere '600 6000 60000 600000' $general
    for size in 600 6000 60000 600000; do
        [ $size -le "$most" ] || break
        scene sphere $size
        two_of 'balls: two through one another' "$file" .3,.2,.1 $general || break
    done
    for size in 600 6000 60000 600000; do
        [ $size -le "$most" ] || break
        scene sphere $size
        two_of 'balls: one behind the other' "$file" .1,-.05,3 --view top || break
    done
    grow 'speck: two balls in one spot' speck '600 6000 60000 600000' $general
    for model in qhull_sphere30000_Qt antiprism_geo_ico_50; do
        file=$shared/models/$model.off
        if [ ! -f "$file" ]; then
            say "no $file: left out"
            continue
        fi
        measure worst stages "$model" 3 1 null $general "$file"
        two_of "$model: two through one another" "$file" .3,.2,.1 $general
        two_of "$model: one behind the other" "$file" .1,-.05,3 --view top
    done
}

# mesh NAME FAMILY "SIZES" OPTION...: measures a mesh of increasing size, up to $triangles
mesh() {
    of_meshes stages "$@"
}

# regions NAME FAMILY "SIZES" OPTION...: the same, without and with what is seen of each face
regions() {
    of_meshes hidden "$@"
    of_meshes regions "$@" --regions /dev/null
}

# of_meshes KIND NAME FAMILY "SIZES" OPTION...
of_meshes() {
    kind_of=$1 name=$2 family=$3 sizes=$4
    shift 4
    for size in $sizes; do
        [ "$size" -le "$most" ] && [ "$size" -le "$triangles" ] || break
        scene "$family" "$(argument "$family" "$size")"
        [ "$size" -lt 1000000 ] || large=$file
        measure meshes "$kind_of" "$name" "$(runs_for "$size")" 1 null "$@" $general "$file" || break
    done
}

# meshes TRIANGLES: measures all meshes of at most that many triangles
meshes() {
    triangles=$1
    head_line >"$out/meshes.tsv"
    mesh 'scan' scan '10000 75000 350000 1400000' --crease 40
    mesh 'scan, all edges' scan '10000 75000 350000 1400000' --all-edges
    mesh 'balls' balls '20000 320000 1280000' --crease 40
    mesh 'boulders' boulders '80000 320000 1280000' --crease 40
    mesh 'terrain' terrain '10000 100000 1000000' --crease 40
    mesh 'stars' stars '10000 100000 1000000'
    mesh 'crossing' crossing '20000 320000 1280000' --crease 40
    mesh 'soup' soup '10000 100000 1000000'
    regions 'city' city '1000 10000 100000'
    regions 'lattice' lattice '1000 10000 100000'
    regions 'sphere' sphere '6000 60000 600000'
    regions 'balls' balls '20000 320000'
    regions 'scan, all edges' scan '10000 75000 350000' --all-edges
    regions 'scan' scan '10000 75000 350000' --crease 40
    regions 'terrain, all edges' terrain '10000 100000 1000000' --all-edges
    regions 'terrain' terrain '10000 100000 1000000' --crease 40
}

# count NAME FILE: adds the instructions of a whole run to build/bench/instructions.tsv
count() {
    say "$1 by callgrind"
    valgrind --tool=callgrind --callgrind-out-file="$out/callgrind.$1" "$roberts" -q --threads 1 -f null $general "$2" \
        2>"$out/stats" || {
        say "gave up $1: $(grep -v '^==' "$out/stats" | head -n 1)"
        return
    }
    counted=$(awk '$1 == "totals:" || $1 == "summary:" { n = $2 } END { print n }' "$out/callgrind.$1")
    before=$(awk -v name="$1" '$1 == name { print $2 }' "$baseline" 2>/dev/null)
    printf '%s\t%s\t%s\n' "$1" "$counted" "${before:--}" >>"$out/instructions.tsv"
}

instructions() {
    printf 'scene\tinstructions\tbaseline\n' >"$out/instructions.tsv"
    if ! command -v valgrind >/dev/null 2>&1; then
        say "no valgrind: instructions are not counted"
        return 1
    fi
    for name in lattice22 city100; do
        if [ -f "$shared/scenes/$name.off" ]; then
            count $name "$shared/scenes/$name.off"
        else
            say "no $shared/scenes/$name.off: left out"
        fi
    done
    for family in lattice city wall plates; do
        scene $family "$(argument $family 10000)"
        count $family-10000 "$file"
    done
}

# Scenes that are missing now keep their lines.
renew_baseline() {
    instructions || return
    kept=$baseline
    [ -f "$kept" ] || kept=/dev/null
    {
        echo "# Instructions executed (callgrind; the whole run, --threads 1 -f null $general), kept so that a change" \
            "shows."
        echo "# The -10000 are of make-models. They depend on compiler and C library; these:" \
            "$(${CC:-cc} --version | head -n 1)."
        echo "# Written by: make bench-baseline"
        awk 'FNR == 1 { file++ }
            file == 1 && FNR > 1 { print $1, $2; counted[$1] = 1 }
            file == 2 && !/^#/ && !($1 in counted)' "$out/instructions.tsv" "$kept"
    } >"$baseline.part" && mv "$baseline.part" "$baseline"
}

# show TABLE PART...: prints a table from the rows of those parts that exist
show() {
    table=$1 rows=
    shift
    for part in "$@"; do
        [ ! -s "$out/$part.tsv" ] || rows="$rows $out/$part.tsv"
    done
    [ -z "$rows" ] || awk -v table="$table" -f tools/bench-table.awk $rows
}

# ---- the command -----------------------------------------------------------------------------------------------------

[ -x "$roberts" ] && [ -x "$build/tools/make-models" ] && [ -x "$build/tools/bench-read" ] ||
    die "not built: make all tools"
mkdir -p "$out" || exit 1
trap 'rm -f "$out/scene.part" "$out/moved.off" "$out/runs" "$out/stats" "$large"' EXIT
trap 'exit 130' INT TERM
[ $# -gt 0 ] || set -- scenes worst meshes instructions

for part in "$@"; do
    case $part in
    scenes) scenes ;;
    worst) worst ;;
    meshes) meshes 350000 ;;
    all-meshes) meshes 2000000 ;;
    instructions) instructions ;;
    baseline) renew_baseline ;;
    tables) set -- scenes worst meshes instructions ;;
    *)
        sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2
        exit 2
        ;;
    esac
done

echo "$("$roberts" --version), $(${CC:-cc} --version | head -n 1), $(uname -m), $(getconf _NPROCESSORS_ONLN) cores"
[ ! -r /proc/loadavg ] ||
    echo "processes at work on this machine in the last minutes: $(cut -d ' ' -f 1-3 /proc/loadavg)"
for which in "$@"; do
    case $which in
    scenes)
        show stages scenes
        show draw scenes
        show threads scenes
        show verify scenes
        show read read
        show goals read scenes
        ;;
    worst) show stages worst ;;
    meshes | all-meshes)
        show stages meshes
        show meshes meshes
        show regions meshes
        ;;
    *) show instructions instructions ;;
    esac
done
