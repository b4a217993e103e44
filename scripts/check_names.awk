# Finds names of scripts/words.txt among declarations. Reads name, kind, file and line with tabs between them (scripts/check_words.sh prints them).
# usage: awk -v table=words.txt -f check_names.awk < declarations
# Prints file:line: the name and what to write instead; the exit code is 1 where there is one.

BEGIN {
  FS = "\t"
  while ((getline entry < table) > 0) {
    if (entry !~ /^(avoid|allow)/) continue
    split(entry, part, /[ \t]+/)
    rest = entry
    for (i = 1; i <= 3; ++i) sub(/^[^ \t]+[ \t]+/, "", rest)
    if (part[1] == "avoid") {
      pattern[++num_patterns] = "^(" part[2] ")$"
      kinds[num_patterns] = part[3]
      instead[num_patterns] = rest
    } else {
      allowed[part[2], part[3]] = entry
    }
  }
}

function is_type(kind) { return kind ~ /^(class|struct|union|enum|typedef)$/ }

function is_allowed(name, file,    key, part) {
  for (key in allowed) {
    split(key, part, SUBSEP)
    if (part[1] == name && substr(file, length(file) - length(part[2]) + 1) == part[2]) return 1
  }
  return 0
}

$1 !~ /^__anon/ && $2 != "macro" {
  bare = tolower($1)
  sub(/_+$/, "", bare)
  for (i = 1; i <= num_patterns; ++i) {
    if (bare !~ pattern[i] || (kinds[i] == "types" && !is_type($2))) continue
    if (!is_allowed($1, $3)) {
      print $3 ":" $4 ": " $2 " " $1 ": not a name of concino; write " instead[i]
      found = 1
    }
    break
  }
}

END { exit found }
