# Runs the exploration experiments. Needs common.sh and run_experiments.sh.

declare -A EXPLORED_WORLDS=() # name -> its file

# choose_worlds NAMES: those named, with commas; without a name, all that there are.
choose_worlds() {
  local name swarmlab=${OMEGA_SLAM_DATA:-}/maps/swarmlab_map.yaml
  for name in $(tr ',' ' ' <<<"${1:-lab,office,maze,swarmlab}"); do
    local file=$OMEGA_SLAM_ROOT/maps/$name.world.yaml
    [[ $name != swarmlab ]] || file=$swarmlab
    if [[ -f $file ]]; then
      EXPLORED_WORLDS[$name]=$file
    else
      [[ -z $1 ]] || die "There is no world $name: $file was not found."
      say "The world $name is left out: $file was not found."
    fi
  done
}

# run_exploration_experiments RUNS STRATEGIES JOBS
run_exploration_experiments() {
  local runs=$1 strategies=$2 jobs=$3 name
  new_tables
  "$EXPERIMENTS_TREE/benchmark/detector_experiments" >"$TABLES/detectors.csv" ||
    die 'The detectors could not be measured.'
  local processes=() process failed=false
  for name in "${!EXPLORED_WORLDS[@]}"; do
    while (($(jobs -rp | wc -l) >= jobs)); do wait -n || failed=true; done
    "$EXPERIMENTS_TREE/benchmark/exploration_experiments" "${EXPLORED_WORLDS[$name]}" \
      --urdf "$OMEGA_SLAM_ROOT/urdf/turtlebot2.urdf" --name "$name" --seeds "$runs" --random-starts \
      --strategies "$strategies" --bound --out "$TABLES" &
    processes+=($!)
  done
  for process in "${processes[@]}"; do wait "$process" || failed=true; done
  ! $failed || die 'An exploration has failed.'
}
