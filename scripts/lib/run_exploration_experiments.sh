# Runs the exploration experiments. Needs common.sh and run_experiments.sh.

EXPLORED_WORLDS=() # names, in the order in which they are run

# file_of_world NAME
file_of_world() {
  if [[ $1 == swarmlab ]]; then
    say "${OMEGA_SLAM_DATA:-}/maps/swarmlab_map.yaml"
  else
    say "$OMEGA_SLAM_ROOT/maps/$1.world.yaml"
  fi
}

# choose_worlds NAMES: those named, with commas; without a name, all that there are.
choose_worlds() {
  local name file
  for name in $(tr ',' ' ' <<<"${1:-office,lab,maze,swarmlab}"); do
    file=$(file_of_world "$name")
    if [[ -f $file ]]; then
      EXPLORED_WORLDS+=("$name")
    else
      [[ -z $1 ]] || die "There is no world $name: $file was not found."
      say "The world $name is left out: $file was not found."
    fi
  done
}

# run_exploration_experiments RUNS STRATEGIES OFFICE_STRATEGIES JOBS
run_exploration_experiments() {
  local runs=$1 strategies=$2 office_strategies=$3 jobs=$4 name names
  new_tables
  "$EXPERIMENTS_TREE/benchmark/detector_experiments" >"$TABLES/detectors.csv" ||
    die 'The detectors could not be measured.'
  local processes=() process failed=false
  for name in "${EXPLORED_WORLDS[@]}"; do
    names=$strategies
    [[ $name != office ]] || names=$office_strategies
    while (($(jobs -rp | wc -l) >= jobs)); do wait -n || failed=true; done
    "$EXPERIMENTS_TREE/benchmark/exploration_experiments" "$(file_of_world "$name")" \
      --urdf "$OMEGA_SLAM_ROOT/urdf/turtlebot2.urdf" --name "$name" --seeds "$runs" --random-starts \
      --strategies "$names" --bound --out "$TABLES" &
    processes+=($!)
  done
  for process in "${processes[@]}"; do wait "$process" || failed=true; done
  ! $failed || die 'An exploration has failed.'
}
