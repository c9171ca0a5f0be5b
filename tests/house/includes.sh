#!/bin/sh
# A chapter includes common/ and itself and earlier chapters; common/ includes no chapter; what is included exists.
set -eu
wrong=$(
    grep -rnoE '#include "[^"]+"' chapters common --include='*.hpp' --include='*.cpp' | awk -F: '{
        file = $1; name = $3; gsub(/#include "|"/, "", name)
        if (file ~ /^common\// && name !~ /^common\//) print file ":" $2 ": common/ includes " name
        if (file ~ /^chapters\//) {
            if (name !~ /^(common|chapters)\//) print file ":" $2 ": " name " is not named from the top of the tree"
            if (name ~ /^chapters\// && substr(name, 10, 2) > substr(file, 10, 2))
                print file ":" $2 ": reaches up to " name
        }
    }'
    grep -rhoE '#include "(common|chapters)/[^"]+"' chapters common tests exercises --exclude-dir=work --include='*.hpp' --include='*.cpp' |
        sed 's/#include "\(.*\)"/\1/' | sort -u | while read -r header; do
        [ -e "$header" ] || echo "$header is included, but is not there"
    done
)
[ -z "$wrong" ] || { printf '%s\n' "$wrong"; exit 1; }
echo "$(find chapters common -name '*.hpp' | wc -l) headers include only what they may"
