# Configures and builds a build tree quietly. Needs common.sh.

# tree_is_stale DIRECTORY ARGUMENTS: whether DIRECTORY was configured otherwise, or for a checkout
# that lay elsewhere.
tree_is_stale() {
  local tree=$1 wanted=$2
  [[ -f $tree/build.ninja && -f $tree/configured_with ]] || return 0
  [[ $(<"$tree/configured_with") != "$wanted" ]]
}

# configure_tree DIRECTORY CMAKE_ARGUMENT...
configure_tree() {
  local tree=$1 name log
  shift
  name=$(basename "$tree")
  log=$LOG_DIR/configure_$name.log
  local arguments=(-S "$OMEGA_SLAM_ROOT" -B "$tree" -G Ninja "$@")
  if command -v ccache >/dev/null; then
    arguments+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  tree_is_stale "$tree" "${arguments[*]}" || return 0
  rm -f "$tree/CMakeCache.txt" "$tree/configured_with"
  mkdir -p "$tree"
  if ! cmake "${arguments[@]}" >"$log" 2>&1; then
    say "CMake could not configure $name:"
    grep -A 8 -m 1 'CMake Error' "$log" || tail -n 20 "$log"
    say "The full log is $log."
    return 1
  fi
  printf '%s' "${arguments[*]}" >"$tree/configured_with"
}

# Turns ninja's lines, such as "[12/345] Building CXX object ...", into a progress line.
watch_build() {
  local name=$1 log=$2 line
  while IFS= read -r line; do
    printf '%s\n' "$line" >>"$log"
    # Looking for new source files is a step to ninja, but not to anybody else.
    if [[ $line != *Re-* && $line =~ ^\[([0-9]+)/([0-9]+)\]\ (.*)$ ]]; then
      show_progress "build $name" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" \
        "$(basename "${BASH_REMATCH[3]##* }")"
    fi
  done
  finish_progress
}

# build_tree DIRECTORY JOBS [TARGET...]
build_tree() {
  local tree=$1 jobs=$2 name log
  shift 2
  name=$(basename "$tree")
  log=$LOG_DIR/build_$name.log
  : >"$log"
  if ! ninja -C "$tree" -j "$jobs" "$@" 2>&1 | watch_build "$name" "$log"; then
    say "Building $name failed:"
    grep -E '(error:|undefined reference|CMake Error)' "$log" | cut -c1-300 | head -n 8 ||
      tail -n 10 "$log"
    say "The full log is $log."
    return 1
  fi
}
