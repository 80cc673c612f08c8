# Tables from the rows of bench.sh:
#
#     awk -v table=stages|draw|threads|verify|read|goals|meshes|regions|instructions -f bench-table.awk FILE.tsv...
#
# The names in a file's first row identify the columns.
BEGIN {
    FS = "\t"
    stage_count = split("read solids view grid hide draw total", stage, " ")
}

function value(name) {
    return $(column[name])
}

# 1234567 as 1,234,567
function grouped(n,   s) {
    s = sprintf("%d", n)
    while (match(s, /^[0-9][0-9][0-9][0-9]+/))
        s = substr(s, 1, RLENGTH - 3) "," substr(s, RLENGTH - 2)
    return s
}

# Exponent e of b / a = (size_b / size_a) ^ e; times below two milliseconds are meaningless
function exponent(a, b, size_a, size_b, least) {
    if (a <= least || b <= least || size_b <= size_a * 1.5)
        return "-"
    return sprintf("%.2f", log(b / a) / log(size_b / size_a))
}

function title(text) {
    printf "\n%s\n", text
}

FNR == 1 {
    split("", column)
    for (i = 1; i <= NF; i++)
        column[$i] = i
    if (NR > 1)
        next
    if (table == "stages") {
        title("Stages, seconds; one thread, nothing written. draw: SVG with --order none, in a run of its own, not\n" \
              "in the total. growth: exponent over the number of edges. MB: peak memory; beyond: the same less the\n" \
              "size of the input, bytes per solid.\n" \
              "pairs/edge: how many fronts or faces an edge is tested against.")
    } else if (table == "draw") {
        title("Drawn as SVG with --order none, and ordered for short travel (small drawings with more care).\n" \
              "more: peak memory beyond that of the same run with nothing written.")
        printf "%-24s%12s%12s%10s%10s%16s%10s\n", "", "solids", "segments", "cpu s", "wall s", "s / M segments", \
            "more MB"
    } else if (table == "threads") {
        title("Two threads against one, wall-clock seconds; means little where other work is going on")
        printf "%-24s%12s%8s%8s%9s%8s%8s%9s%8s%8s%9s\n", "", "solids", "read 1", "2", "times", "hide 1", "2", "times", \
            "total 1", "2", "times"
    } else if (table == "verify") {
        title("Checked by rays (--verify, three points of each segment) against hidden (view, grid and hide), CPU s")
        printf "%-24s%12s%12s%10s%10s%8s\n", "", "solids", "segments", "hidden", "checked", "times"
    } else if (table == "read") {
        title("Reading, and the same numbers by strtod(), CPU seconds")
        printf "%-24s%14s%14s%10s%10s%8s%8s\n", "", "bytes", "numbers", "read", "strtod", "times", "MB/s"
    } else if (table == "goals") {
        title("In short (CPU seconds of one thread where nothing else is said)")
    } else if (table == "meshes") {
        title("Meshes in short: CPU seconds of one thread, reading included; growth from the smallest size, over edges")
        printf "%-24s%12s%12s%12s%10s%8s%10s%8s%10s\n", "", "triangles", "edges", "segments", "total", "goal", "MB", \
            "goal", "growth"
    } else if (table == "regions") {
        title("What is seen of each face, against hidden lines (view, grid and hide), CPU seconds of one thread. " \
              "regions:\n" \
              "what they add, hiding the edges that are not drawn included. The goal is 3 times at the most. " \
              "written: as\n" \
              "JSON; growth: of the regions, from the smallest size, over edges")
        printf "%-24s%12s%12s%10s%10s%8s%10s%10s\n", "", "faces", "segments", "hidden", "regions", "times", "written", \
            "growth"
    } else {
        title("Instructions executed, reading included")
        printf "%-24s%16s%16s%10s\n", "", "now", "baseline", "change"
    }
    next
}

table == "stages" && value("kind") == "draw" {
    drawn_cpu[value("scene"), value("bytes")] = value("draw_cpu")
    drawn_wall[value("scene"), value("bytes")] = value("draw_wall")
}

table == "stages" && value("kind") == "stages" {
    row[++rows] = $0
}

# Bytes of memory per solid, less the input
function beyond() {
    return (value("peak_memory_kb") * 1024 - value("bytes")) / value("solids")
}

# One size of a scene: one line for each clock and, from the second size on, one for the growth.
function print_size(   i, v, line, edges, scene, key) {
    scene = value("scene") "  " value("options")
    if (scene != last_scene) {
        printf "\n%s\n%12s%12s%12s%9s", scene, "solids", "edges", "segments", ""
        for (i = 1; i <= stage_count; i++)
            printf "%8s", stage[i]
        printf "%11s%9s%8s%12s%12s\n", "s/M edges", "MB", "beyond", "total/read", "pairs/edge"
        last_edges = 0
    }
    if (value("runs") == 0) {
        printf "%44s: given up\n", grouped(value("bytes")) " bytes"
        return
    }
    edges = value("edges")
    key = value("scene") SUBSEP value("bytes")
    printf "%12s%12s%12s%9s", grouped(value("solids")), grouped(edges), grouped(value("segments")), "cpu"
    for (i = 1; i <= stage_count; i++) {
        v = stage[i] == "draw" ? drawn_cpu[key] : value(stage[i] "_cpu")
        printf v == "" ? "%8s" : "%8.3f", v == "" ? "-" : v
    }
    printf "%11.3f%9.0f%8s%12s%12.1f\n%45s", value("total_cpu") * 1e6 / edges, value("peak_memory_kb") / 1024, \
        value("solids") < 1000 ? "-" : sprintf("%.0f", beyond()), \
        value("read_cpu") < 0.002 ? "-" : sprintf("%.1f", value("total_cpu") / value("read_cpu")), \
        value("pairs") / edges, "wall"
    for (i = 1; i <= stage_count; i++) {
        v = stage[i] == "draw" ? drawn_wall[key] : value(stage[i] "_wall")
        printf v == "" ? "%8s" : "%8.3f", v == "" ? "-" : v
    }
    print ""
    if (scene == last_scene && last_edges) {
        printf "%24s%12s%9s", "", exponent(last["segments"], value("segments"), last_edges, edges, 0), "growth"
        for (i = 1; i <= stage_count; i++) {
            v = stage[i] == "draw" ? drawn_cpu[key] : value(stage[i] "_cpu")
            printf "%8s", exponent(last[stage[i]], v, last_edges, edges, 0.002)
        }
        print ""
    }
    for (i = 1; i <= stage_count; i++)
        last[stage[i]] = stage[i] == "draw" ? drawn_cpu[key] : value(stage[i] "_cpu")
    last["segments"] = value("segments")
    last_edges = edges
    last_scene = scene
}

(table == "draw" || table == "threads") && value("kind") == "stages" && value("runs") > 0 {
    key = value("scene") SUBSEP value("bytes")
    kb[key] = value("peak_memory_kb")
    read_1[key] = value("read_wall")
    hide_1[key] = value("hide_wall")
    total_1[key] = value("total_wall")
}

function more_mb() {
    return (value("peak_memory_kb") - kb[value("scene"), value("bytes")]) / 1024
}

table == "draw" && (value("kind") == "draw" || value("kind") == "plot") && value("runs") > 0 {
    key = value("scene") SUBSEP value("bytes")
    printf "%-24s%12s%12s%10.3f%10.3f%16.2f%10d\n", value("scene") (value("kind") == "plot" ? ", ordered" : ""), \
        grouped(value("solids")), grouped(value("segments")), \
        value("draw_cpu"), value("draw_wall"), value("draw_cpu") * 1e6 / value("segments"), more_mb()
}

table == "verify" && value("kind") == "verify" && value("runs") > 0 {
    hiding = value("view_cpu") + value("grid_cpu") + value("hide_cpu")
    printf "%-24s%12s%12s%10.3f%10.3f%8s\n", value("scene"), grouped(value("solids")), grouped(value("segments")), \
        hiding, value("verify_cpu"), times(value("verify_cpu"), hiding)
}

function times(a, b) {
    return b > 0 ? sprintf("%.2f", a / b) : "-"
}

table == "threads" && value("kind") == "threads" && value("runs") > 0 {
    key = value("scene") SUBSEP value("bytes")
    printf "%-24s%12s%8.3f%8.3f%9s%8.3f%8.3f%9s%8.3f%8.3f%9s\n", value("scene"), grouped(value("solids")), \
        read_1[key], \
        value("read_wall"), times(read_1[key], value("read_wall")), hide_1[key], value("hide_wall"), \
        times(hide_1[key], value("hide_wall")), total_1[key], value("total_wall"), \
        times(total_1[key], value("total_wall"))
}

table == "read" {
    printf "%-24s%14s%14s%10.3f%10.3f%8.2f%8.0f\n", value("scene"), grouped(value("bytes")), \
        grouped(value("numbers")), \
        value("read_cpu"), value("strtod_cpu"), value("times"), value("bytes") / value("read_cpu") / 1e6
}

# The goals of a mesh of that many triangles: seconds or megabytes, "-" if there is none.
function mesh_goal(scene, triangles, unit,   goal) {
    goal["scan 74420 s"] = 0.04
    goal["scan 74420 MB"] = 20
    goal["scan, all edges 74420 s"] = 0.05
    goal["scan 1393920 s"] = 0.4
    goal["scan 1393920 MB"] = 150
    goal["balls 1280000 s"] = 0.6
    goal["boulders 1280000 s"] = 0.6
    goal["soup 1000000 s"] = 1.2
    scene = scene " " triangles " " unit
    return scene in goal ? goal[scene] : "-"
}

# Hiding, and regions if they are wanted
function found_cpu() {
    return value("view_cpu") + value("grid_cpu") + value("hide_cpu") + value("regions_cpu")
}

table == "regions" && value("kind") == "hidden" {
    hidden[value("scene"), value("bytes")] = found_cpu()
}

table == "regions" && value("kind") == "regions" && value("runs") > 0 {
    key = value("scene")
    hiding = hidden[key, value("bytes")]
    added = found_cpu() - hiding
    if (!(key in from_total)) {
        from_edges[key] = value("edges")
        from_total[key] = added
    }
    printf "%-24s%12s%12s%10.3f%10.3f%8s%10.3f%10s\n", key, grouped(value("faces")), \
        grouped(value("segments")), hiding, added, times(added, hiding), value("draw_cpu"), \
        exponent(from_total[key], added, from_edges[key], value("edges"), 0.002)
}

table == "meshes" && value("kind") == "stages" && value("runs") > 0 {
    key = value("scene")
    if (!(key in from_total)) {
        from_edges[key] = value("edges")
        from_total[key] = value("total_cpu")
    }
    printf "%-24s%12s%12s%12s%10.3f%8s%10.0f%8s%10s\n", key, grouped(value("faces")), grouped(value("edges")), \
        grouped(value("segments")), value("total_cpu"), mesh_goal(key, value("faces"), "s"), \
        value("peak_memory_kb") / 1024, mesh_goal(key, value("faces"), "MB"), \
        exponent(from_total[key], value("total_cpu"), from_edges[key], value("edges"), 0.002)
}

table == "instructions" {
    printf "%-24s%16s%16s%10s\n", value("scene"), grouped(value("instructions")), \
        value("baseline") == "-" ? "-" : grouped(value("baseline")), \
        value("baseline") == "-" ? "-" : sprintf("%+.2f %%", (value("instructions") / value("baseline") - 1) * 100)
}

# ---- in short: each scene's largest size -------------------------------------------------------------------------

table == "goals" && ("times" in column) {
    by_strtod[value("scene")] = value("times")
}

table == "goals" && ("kind" in column) && value("runs") > 0 {
    key = value("scene")
    if (value("kind") == "stages") {
        if (!(key in solids))
            order[++scenes] = key
        if (value("solids") >= 9000 && from_total[key] == "") {
            from_edges[key] = value("edges")
            from_total[key] = value("total_cpu")
        }
        solids[key] = value("solids")
        ratio[key] = value("read_cpu") > 0 ? value("total_cpu") / value("read_cpu") : 0
        per_solid[key] = beyond()
        growth[key] = exponent(from_total[key], value("total_cpu"), from_edges[key], value("edges"), 0.002)
        kb[key, value("bytes")] = value("peak_memory_kb")
        one_read[key] = value("read_wall")
        one_hide[key] = value("hide_wall")
    } else if (value("kind") == "draw") {
        svg[key] = sprintf("%8.2f%8s", value("draw_cpu") * 1e6 / value("segments"), \
            value("segments") < 1e5 ? "-" : sprintf("%d", more_mb() * 1e6 / value("segments")))
    } else if (value("kind") == "threads") {
        two[key] = sprintf("%8s%8s", times(one_hide[key], value("hide_wall")), times(one_read[key], value("read_wall")))
    }
}

function print_goals(   i, key) {
    printf "%-12s%11s%10s%10s%10s%14s%16s%16s\n", "", "", "", "by strtod", "growth", "beyond input", "2 threads,", \
        "a million"
    printf "%-12s%11s%10s%10s%10s%14s%16s%16s\n", "", "", "total", "against", "from 1e4", "bytes per", "wall: times", \
        "segments, SVG"
    printf "%-12s%11s%10s%10s%10s%14s%8s%8s%8s%8s\n", "", "solids", "/ read", "read", "solids", "solid", "hide", \
        "read", "s", "more MB"
    for (i = 1; i <= scenes; i++) {
        key = order[i]
        printf "%-12s%11s%10.1f%10s%10s%14.0f%16s%16s\n", key, grouped(solids[key]), ratio[key], by_strtod[key], \
            growth[key], \
            per_solid[key], two[key], svg[key]
    }
    printf "%-12s%11s%10s%10s%10s%14s%8s%8s%8s%8s\n", "goal", "1,000,000", "<= 4.5", ">= 4", "<= 1.05", "<= 1000", \
        ">= 1.8", \
        ">= 1.5", "<= 1.5", "<= 300"
}

END {
    if (table == "goals")
        print_goals()
    for (r = 1; r <= rows; r++) {
        $0 = row[r]
        print_size()
    }
}
