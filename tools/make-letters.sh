#!/bin/sh
# Writes the strokes of the letters as a C header: tools/make-letters.sh FOLDER. FOLDER holds fonts of A. V. Hershey as
# files of J. Hurt's format (Debian: hershey-fonts-data). A line of a file is a character, from the blank to the one of
# code 127: five columns of its number, three of its length, then pairs of letters, which src/draw/letters.c reads.
set -eu

table() {
    printf 'static const char *const %s[] = {\n' "$2"
    sed -e 's/^........//' -e 's/[\\"?]/\\&/g' -e 's/.*/    "&",/' "$1"
    printf '};\n'
}

for font in futural greeks; do
    [ -r "$1/$font.jhf" ] || {
        echo "$0: there is no $1/$font.jhf; Debian has it in hershey-fonts-data, elsewhere: make HERSHEY=FOLDER" >&2
        exit 1
    }
done
printf '/* Hershey fonts, created by A. V. Hershey at the U. S. National Bureau of Standards;\n'
printf ' * their format was created by James Hurt, Cognition, Inc., 900 Technology Park Drive,\n'
printf ' * Billerica, MA 01821. */\n'
table "$1/futural.jhf" letters_latin
table "$1/greeks.jhf" letters_greek
