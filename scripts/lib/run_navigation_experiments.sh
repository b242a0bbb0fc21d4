# Runs the experiments on navigation. Needs common.sh and run_experiments.sh.

NAVIGATION_PROGRAM=$EXPERIMENTS_TREE/benchmark/navigation_experiments
NAVIGATION_WORLDS=(lab office maze swarmlab)
COMPARED_PLANNERS=(RRTConnect RRTstar InformedRRTstar PRMstar) # in the lab, beside the grid search

# navigation_map NAME: path of a world's map; empty where it is not known.
navigation_map() {
  case $1 in
    swarmlab) [[ -z ${OMEGA_SLAM_DATA:-} ]] || say "$OMEGA_SLAM_DATA/maps/swarmlab_map.yaml" ;;
    *) say "$OMEGA_SLAM_ROOT/maps/$1.yaml" ;;
  esac
}

# navigate TABLE MAP ARGUMENT...: adds the rows of one run to a table.
navigate() {
  local table=$TABLES/$1.csv map=$2 log=$LOG_DIR/experiment_navigation.log rows
  shift 2
  rows=$("$NAVIGATION_PROGRAM" --map "$map" --urdf "$OMEGA_SLAM_ROOT/urdf/turtlebot2.urdf" "$@" \
    2>>"$log") || die "The experiment on $map has failed." "All that was said is in $log."
  [[ -f $table ]] || head -n 1 <<<"$rows" >"$table"
  tail -n +2 <<<"$rows" >>"$table"
  DONE=$((DONE + 1))
  show_progress 'runs' "$DONE" "$RUNS"
}

# run_navigation_experiments QUERIES GOALS SEEDS
run_navigation_experiments() {
  local queries=$1 goals=$2 seeds=$3 world map planner seed
  new_tables
  RUNS=$(((1 + seeds) * ${#NAVIGATION_WORLDS[@]} + ${#COMPARED_PLANNERS[@]}))
  for world in "${NAVIGATION_WORLDS[@]}"; do
    map=$(navigation_map "$world")
    if [[ ! -f $map ]]; then
      say "Without $world: OMEGA_SLAM_DATA does not lead to its map."
      RUNS=$((RUNS - 1 - seeds))
      continue
    fi
    navigate queries "$map" queries --count "$queries"
    for ((seed = 1; seed <= seeds; ++seed)); do
      navigate goals "$map" --seed "$seed" goals --count "$goals"
    done
  done
  for planner in "${COMPARED_PLANNERS[@]}"; do
    navigate planners "$(navigation_map lab)" queries --planner "$planner" \
      --count "$(((queries + 9) / 10))"
  done
  finish_progress
}
