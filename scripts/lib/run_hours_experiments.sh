# Runs the experiments on drives that last for hours. Needs common.sh, run_experiments.sh and
# run_graph_experiments.sh, whose program it takes.

KEYFRAMES_AN_HOUR=4000 # of a TurtleBot by default

# drive_on TABLE HOURS ARGUMENT...
drive_on() {
  local table=$1 hours=$2 line done=0
  shift 2
  "$GRAPH_PROGRAM" hours --per-hour "$KEYFRAMES_AN_HOUR" \
    --keyframes $((hours * KEYFRAMES_AN_HOUR)) "$@" 2>>"$LOG_DIR/experiment_graph_hours.log" |
    while IFS= read -r line; do
      say "$line" >>"$TABLES/$table.csv"
      show_progress "hours, $table" "$done" "$hours"
      done=$((done + 1))
    done || die "A drive has failed." "All that was said is in $LOG_DIR/experiment_graph_hours.log."
  finish_progress
}

# run_hours_experiments HOURS UNTHINNED_HOURS
run_hours_experiments() {
  new_tables
  drive_on thinned "$1"
  drive_on kept "$2" --keyframes-per-place 0
}
