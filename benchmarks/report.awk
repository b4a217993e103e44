# Joins the rows of the benchmark programs with the budgets: prints the table and writes everything as JSON.
# usage: awk -v json=FILE -v about="COMPILER AND DATE" -f report.awk budgets.tsv rows.tsv...

BEGIN { FS = "\t" }
/^#/ { next }
FILENAME == ARGV[1] { against[$1] = $2; limit[$1] = $3; next }
{
  work = $1; who = $2
  if (!(work in unit)) { order[++works] = work; unit[work] = $3; names[work] = "" }
  if (!((work, who) in value)) names[work] = names[work] (names[work] == "" ? "" : SUBSEP) who
  value[work, who] = $4; ours_over[work, who] = $5
}

function show(x) { return x == "" ? "-" : sprintf(x >= 100 ? "%.0f" : x >= 0.1 ? "%.3f" : "%.5f", x) }

# The library's value as a multiple of what the budget compares it with, or "" where that was not measured.
function measured(work,   a, part) {
  if (!((work, "concino") in value)) return ""
  a = against[work]
  if (a == "-") return value[work, "concino"]
  if (split(a, part, ":") == 2) return (part[1], part[2]) in value ? value[work, "concino"] / value[part[1], part[2]] : ""
  return (work, a) in value ? ours_over[work, a] : ""
}

END {
  format = "%-22s %6s %10s %10s %7s  %-20s %10s %7s  %-26s %7s  %s\n"
  printf format, "work", "unit", "floor", "concino", "ratio", "best peer", "", "ratio", "budget", "is", "met"
  print "{\n  \"about\": \"" about "\",\n  \"works\": [" > json
  for (i = 1; i <= works; ++i) {
    work = order[i]; n = split(names[work], name, SUBSEP); best = ""
    line = ""
    for (k = 1; k <= n; ++k) {
      line = line (k > 1 ? ", " : "") \
        sprintf("\"%s\": {\"value\": %s, \"concino_over_it\": %s}", name[k], value[work, name[k]], ours_over[work, name[k]])
      if (name[k] != "floor" && name[k] != "concino" && (best == "" || value[work, name[k]] + 0 < value[work, best] + 0)) best = name[k]
    }
    is = work in limit ? measured(work) : ""
    met = is == "" ? "" : (is + 0 <= limit[work] + 0 ? "yes" : "NO")
    if (met == "NO") ++missed
    if (met != "") ++judged
    budget = !(work in limit) ? "" : "<= " limit[work] (against[work] == "-" ? "" : " x " against[work])
    printf format, work, unit[work], show(value[work, "floor"]), show(value[work, "concino"]), show(ours_over[work, "floor"]),
      best, best == "" ? "" : show(value[work, best]), best == "" ? "" : show(ours_over[work, best]), budget, show(is), met
    printf "%s    {\"work\": \"%s\", \"unit\": \"%s\", \"contenders\": {%s}", comma, work, unit[work], line > json
    comma = ",\n"
    truth = met == "yes" ? "true" : "false"
    if (is != "")
      printf ", \"budget\": {\"against\": \"%s\", \"limit\": %s, \"is\": %.4g, \"met\": %s}", against[work], limit[work], is, truth > json
    printf "}" > json
  }
  print "\n  ]\n}" > json
  printf "%d budgets judged, %d missed\n", judged, missed
}
