# Runs the experiments on maps. Needs common.sh, run_experiments.sh, and run_matching_experiments.sh
# and run_slam_experiments.sh, whose maps and tables' rows it takes.

MAP_PROGRAM=$EXPERIMENTS_TREE/benchmark/map_experiments
declare -A DRIVES_BEGIN=([lab]='1.2 3.4' [swarmlab]='0 0') # near there [m], in the map's frame

# explore EXPERIMENT NAME ARGUMENT...: one run of the program, in the building of that name.
explore() {
  local experiment=$1 name=$2
  local log=$LOG_DIR/experiment_maps.log
  shift 2
  # shellcheck disable=SC2086  # two numbers
  "$MAP_PROGRAM" "$experiment" --map "${MAPS[$name]}" --name "$name" \
    --near ${DRIVES_BEGIN[$name]} --out "$PART_TABLES" "$@" >>"$log" 2>&1 </dev/null ||
    die "An experiment in $name has failed:" "$(tail -n 3 "$log")"
  DONE=$((DONE + 1))
  show_progress 'runs' "$DONE" "$RUNS"
}

# run_map_experiments SEEDS
run_map_experiments() {
  local seeds=$1 name seed table part
  new_tables
  rm -rf "$PART_TABLES"
  mkdir -p "$PART_TABLES"
  DONE=0 RUNS=$((${#MAPS[@]} * (seeds + 1)))
  for name in "${!MAPS[@]}"; do
    explore survey "$name" --seed 1 --pictures
    for ((seed = 2; seed <= seeds; ++seed)); do explore survey "$name" --seed "$seed"; done
    explore peer "$name"
  done
  finish_progress
  say 'Now the times, which takes some minutes.'
  "$EXPERIMENTS_TREE/benchmark/mapping_benchmark" --benchmark_repetitions=3 \
    --benchmark_out="$PART_TABLES/times.csv" --benchmark_out_format=csv \
    >"$LOG_DIR/experiment_times.log" 2>&1 ||
    die 'The times could not be taken:' "$(tail -n 3 "$LOG_DIR/experiment_times.log")"
  sed -n '/^name,/,$p' "$PART_TABLES/times.csv" >"$TABLES/times.csv" # without what stands above
  for table in surveys scores peer; do
    for part in "$PART_TABLES/$table"_*.csv; do append_rows "$part" "$TABLES/$table.csv"; done
  done
}

# publish_maps OUT: the pictures, too.
publish_maps() {
  mkdir -p "$1/maps"
  cp "$PART_TABLES"/*.png "$1/maps/"
  publish maps "$1"
}
