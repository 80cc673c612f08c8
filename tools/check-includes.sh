#!/bin/sh
# Checks that the includes of src/ point one way: tools/check-includes.sh [FOLDER] (default: the top folder).
#
# A room may include headers of its own and of the rooms below it:
#     web > cli > part > write > draw, ray, hide > view > model > read > base
# Rooms on one level never include one another, so that hide and ray can check each other. cli is a client of roberts.h
# alone. Cairo is included in write only, Qhull in model only. `make test` runs this.
set -eu
cd "${1:-$(dirname "$0")/..}"

grep -n '^[[:space:]]*#[[:space:]]*include' src/*/*.[ch] | awk -F: '
    BEGIN {
        split("base read model view hide ray draw write part cli web", name, " ")
        split("1 2 3 4 5 5 5 6 7 8 9", height, " ")
        for (i in name)
            level[name[i]] = height[i]
    }
    function wrong(why) {
        print $1 ":" $2 ": " substr($0, length($1) + length($2) + 3) ": " why
        count++
    }
    {
        split($1, part, "/")
        room = part[2]
        match($3, /["<][^">]*/)
        target = substr($3, RSTART + 1, RLENGTH - 1)
        system_header = substr($3, RSTART, 1) == "<"
        other = target
        sub(/\/.*/, "", other)
        if (!(room in level))
            wrong("the room " room " has no place in tools/check-includes.sh")
        else if (target ~ /cairo/ && room != "write" || target ~ /qhull/ && room != "model" && system_header)
            wrong("this library has its place in another room")
        else if (system_header || target == "roberts.h" || other == room)
            next
        else if (!(other in level))
            wrong("headers are included by their room: \"room/file.h\"")
        else if (room == "cli")
            wrong("cli includes roberts.h and headers of its own alone")
        else if (level[other] >= level[room])
            wrong("includes point downward: web > cli > part > write > draw, ray, hide > view > model > read > base")
    }
    END {
        if (NR < 100)
            wrong("only " NR " includes were found")
        exit count > 0
    }'
