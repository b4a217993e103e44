# Completion of the program concino for bash: commands, options and files.
_concino() {
  local commands="info validate convert repair render view harmonic geodesic demo"
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} options
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands --help --version" -- "$word")
    return
  fi
  case "$before" in
    --kind) mapfile -t COMPREPLY < <(compgen -W "trimesh quadmesh polygonmesh tetmesh hexmesh polyhedralmesh" -- "$word"); return ;;
    --quality) mapfile -t COMPREPLY < <(compgen -W "draft normal print" -- "$word"); return ;;
  esac
  case "$command" in
    info) options="--json" ;;
    validate) options="--all" ;;
    convert) options="--kind --strict --binary --as-triangles --as-boundary --corners-only" ;;
    repair) options="--merge --fill --orient --split --collapse --remove-intersecting" ;;
    render) options="--output --field --slice --edges --size --quality" ;;
    view) options="--field --slice --edges" ;;
    harmonic) options="--values --output" ;;
    geodesic) options="--from --output" ;;
    demo) options="--print" ;;
  esac
  case "$word" in
    -*) mapfile -t COMPREPLY < <(compgen -W "$options --help" -- "$word") ;;
    *) mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
  esac
}
complete -o filenames -F _concino concino
