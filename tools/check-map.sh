#!/bin/sh
# Checks the map of the house, src/README.md: tools/check-map.sh [FOLDER] (default: the top folder). `make test` runs
# it.
#
# "The files of each room" names every source of src/, by itself, by its folder, or by the .c file of the same name. The
# names in italics after a file occur in that file, in its header, or in that folder. A blank in one may be a _ there.
set -eu
cd "${1:-$(dirname "$0")/..}"

{
    find src -name '*.[ch]' -o -name '*.js' -o -name '*.py' | sort | sed 's/^/file /'
    sed -n '/^## The files of each room/,/^## How to add/p' src/README.md
} | awk '
    /^file / { read_source(substr($0, 6)); next }
    /^- `/ { keep_entry() }
    /^- `/, /^$/ { entry = entry " " $0 }
    /^$/ { keep_entry() }

    function wrong(why) {
        print "src/README.md: " why
        count++
    }

    function read_source(file,    line) {
        source[file] = ""
        while ((getline line <file) > 0)
            source[file] = source[file] tolower(line) "\n"
        close(file)
    }

    # The names of an entry, "- `room/file.c`: what it is *(name, name)*"
    function keep_entry(    file, n, i, name) {
        if (entry ~ /^ - `/) {
            split(entry, part, "`")
            file = "src/" part[2]
            listed[file]
            if (match(entry, /\*\([^)]*\)\*/)) {
                n = split(substr(entry, RSTART + 2, RLENGTH - 4), name, ",")
                for (i = 1; i <= n; i++)
                    check_name(file, name[i])
            }
        }
        entry = ""
    }

    # Does some source of the entry hold the name?
    function check_name(file, name,    f, header, found) {
        gsub(/^ +| +$/, "", name)
        gsub(/ +/, " ", name)
        header = file
        sub(/c$/, "h", header)
        for (f in source)
            if (f == file || f == header || (file ~ /\/$/ && index(f, file) == 1))
                found = found || holds(source[f], tolower(name))
        checked++
        if (!found)
            wrong(file ": there is no \"" name "\" in it")
    }

    function holds(text, name) {
        if (index(text, name))
            return 1
        gsub(/ /, "_", name)
        return index(text, name)
    }

    END {
        keep_entry()
        for (f in source) {
            of_header = folder = f
            sub(/h$/, "c", of_header)
            named = f in listed || of_header in listed
            while (!named && sub(/[^\/]+\/?$/, "", folder))
                named = folder in listed
            if (!named)
                wrong(f " is not in the map")
        }
        if (checked < 300)
            wrong("only " checked " names were found")
        exit count > 0
    }'
