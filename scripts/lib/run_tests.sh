# Builds a tree, runs its tests, and counts. Needs common.sh and build.sh.

PASSED=0
SKIPPED=0
FAILURES=()       # names of failed tests, or what else went wrong
RERUN_COMMANDS=() # how to run each again; empty where there is no such command
MAX_LINES_SHOWN=40
TEST_RESULT='^ *([0-9]+)/([0-9]+) Test +#[0-9]+: (.*[^ ]) \.{3,}[^.*]*(\*{3}|  +)([A-Z].*) +[0-9.]+ sec'

add_failure() {
  FAILURES+=("$1")
  RERUN_COMMANDS+=("${2:-}")
}

# rerun_command TREE TEST
rerun_command() {
  local pattern
  pattern=$(sed 's/[][\\.*^$+?(){}|]/\\&/g' <<<"$2")
  printf "(cd %s && ctest -R '^%s\$' --output-on-failure)" "$1" "$pattern"
}

# count_result TREE TEST RESULT, the last as ctest words it
count_result() {
  case $3 in
    Passed*) PASSED=$((PASSED + 1)) ;;
    Skipped* | 'Not Run (Disabled)'*) SKIPPED=$((SKIPPED + 1)) ;;
    *)
      finish_progress
      say "  FAILED $2"
      add_failure "$2" "$(rerun_command "$1" "$2")"
      return 1
      ;;
  esac
}

# Reads ctest's output: counts, shows progress, and what failed tests had to say.
# A result reads "12/345 Test #6: level/module/Suite.Case ....   Passed    0.01 sec", and of a crash
# "... ....Subprocess aborted***Exception:   0.01 sec".
watch_tests() {
  local tree=$1 log=$2 name line lines_left=0 done=0 total=0
  name=$(basename "$tree")
  while IFS= read -r line; do
    printf '%s\n' "$line" >>"$log"
    if [[ $line =~ $TEST_RESULT ]]; then
      lines_left=0
      done=$((done + 1))
      total=${BASH_REMATCH[2]}
      show_progress "test $name" "$done" "$total" "${BASH_REMATCH[3]}"
      count_result "$tree" "${BASH_REMATCH[3]}" "${BASH_REMATCH[5]}" || lines_left=$MAX_LINES_SHOWN
    elif [[ $line =~ ^\ +Start\ +[0-9]+:\  || $line =~ ^[0-9]+%\ tests\ passed ]]; then
      lines_left=0
    elif ((lines_left > 0)); then
      say "    $line"
      lines_left=$((lines_left - 1))
    fi
  done < <(cd "$tree" && ctest --output-on-failure --timeout 300 -j "$jobs" -R "${filter:-.}" 2>&1 ||
    true)
  finish_progress
  # Silence is no success: ctest may have ended early, or found nothing to run.
  if ((done < total)) || [[ $total == 0 && -z $filter ]]; then
    add_failure "ctest in $tree, which ran $done of $total tests"
  fi
}

# test_stage TREE JOBS FILTER CMAKE_ARGUMENT...: what fails is remembered, not thrown.
test_stage() {
  local tree=$1 jobs=$2 filter=$3 name log started=$SECONDS passed_before=$PASSED
  local failed_before=${#FAILURES[@]} skipped_before=$SKIPPED
  shift 3
  name=$(basename "$tree")
  log=$LOG_DIR/test_$name.log
  if ! configure_tree "$OMEGA_SLAM_ROOT/$tree" "$@" ||
    ! build_tree "$OMEGA_SLAM_ROOT/$tree" "$jobs"; then
    add_failure "the build in $tree"
    return 0
  fi
  : >"$log"
  watch_tests "$tree" "$log"
  say "$name: $((PASSED - passed_before)) passed," \
    "$((${#FAILURES[@]} - failed_before)) failed," \
    "$((SKIPPED - skipped_before)) skipped in $((SECONDS - started)) s ($log)"
}

# report_tests FILTER: the closing lines; ends the script with its exit code.
report_tests() {
  if [[ -n $1 ]] && ((PASSED + SKIPPED + ${#FAILURES[@]} == 0)); then
    add_failure "to find a test whose name matches \"$1\""
  fi
  local failed=${#FAILURES[@]} i summary
  if ((failed > 0)); then
    say "Failed: $(printf '%s, ' "${FAILURES[@]}" | sed 's/, $//')."
    for ((i = 0; i < failed; ++i)); do
      [[ -z ${RERUN_COMMANDS[i]} ]] || say "  again: ${RERUN_COMMANDS[i]}"
    done
  fi
  summary="$PASSED passed, $failed failed"
  ((SKIPPED == 0)) || summary+=", $SKIPPED skipped"
  say "$summary"
  exit $((failed > 0))
}
