# Runs the experiments on the graph's solver. Needs common.sh, install.sh and run_experiments.sh.

GRAPH_PROGRAM=$EXPERIMENTS_TREE/benchmark/graph_experiments
GUESSED=$EXPERIMENTS_TREE/graphs # graphs with a first guess, for the peers
GRAPH_NAMES=MIT,CSAIL,intel-carlone,intel,manhattan,manhattanOlson3500,M3500a,city10000
CONTESTANT_LIST=$OMEGA_SLAM_ROOT/scripts/contestants.txt
PLAYED=' manhattan city10000 ' # graphs that come pose by pose, too
GUESSES=(odometry tree chordal)
declare -A GRAPHS=() # name -> file

# A Python environment of our own, in which other solvers are.
PEERS=$OMEGA_SLAM_ROOT/build/peers
PEER_PACKAGES=(gtsam g2o-python 'numpy<2') # g2o-python is built for NumPy 1
OUR_SOLVERS=(ours)                         # those that our program runs
PEER_SOLVERS=(g2o_gn gtsam_gn gtsam_lm)    # none without the environment

# Debian's Ceres brings ATLAS along, which would take the place of the BLAS that all programs of the
# machine use, ours among them; whichever that is stays.
install_contestants() {
  local library link packages
  local -A chosen=()
  for library in blas lapack; do
    for link in /etc/alternatives/lib$library.so.3-*; do
      [[ ! -e $link ]] || chosen[${link##*/}]=$(readlink "$link")
    done
  done
  mapfile -t packages < <(listed_packages "$CONTESTANT_LIST")
  install_packages "${packages[@]}"
  for link in "${!chosen[@]}"; do
    [[ $(readlink "/etc/alternatives/$link") == "${chosen[$link]}" ]] ||
      as_root update-alternatives --quiet --set "$link" "${chosen[$link]}"
  done
}

# choose_graphs NAMES USUAL: fills GRAPHS; without names, with what there is of the usual ones.
choose_graphs() {
  local name path names
  IFS=, read -ra names <<<"${1:-$2}"
  for name in "${names[@]}"; do
    path=${OMEGA_SLAM_DATA:-}/graphs/$name.g2o
    if [[ -f $path ]]; then
      GRAPHS[$name]=$path
    elif [[ -n $1 ]]; then
      die "There is no graph $name: OMEGA_SLAM_DATA does not lead to graphs/$name.g2o."
    else
      say "Without $name: OMEGA_SLAM_DATA does not lead to its graph."
    fi
  done
}

peers_work() { "$PEERS/bin/python" -c 'import g2o, gtsam' 2>/dev/null; }

# prepare_peers INSTALL: sees to it that there are peers, or does without.
prepare_peers() {
  local log=$LOG_DIR/peers.log
  peers_work && return
  if $1; then
    say "Installing other solvers into $PEERS: ${PEER_PACKAGES[*]}"
    python3 -m venv --clear "$PEERS" >"$log" 2>&1 &&
      "$PEERS/bin/pip" install --disable-pip-version-check "${PEER_PACKAGES[@]}" >>"$log" 2>&1 &&
      peers_work && return
    say "That failed, as $log says."
  fi
  say 'Without GTSAM and g2o.'
  PEER_SOLVERS=()
}

describe_peers() {
  "$PEERS/bin/python" -c '
from importlib.metadata import version
print("package,version")
for package in ("g2o-python", "gtsam"):
    print(f"{package},{version(package)}")'
}

# Whether Ceres was there to build with.
built_with_ceres() { grep -q '^Ceres_DIR:PATH=/' "$EXPERIMENTS_TREE/CMakeCache.txt"; }

RUNS=0      # how many there will be
DONE=0      # of them
PROCESSOR=0 # the one on which all run

# measure TABLE COMMAND...: adds the row that a command prints to a table. One at a time, on one
# processor, for its time counts.
measure() {
  local table=$TABLES/$1.csv log=$LOG_DIR/experiment_graph.log rows
  shift
  rows=$(OMP_NUM_THREADS=1 taskset --cpu-list "$PROCESSOR" "$@" 2>>"$log") ||
    die "An experiment has failed: $*" "All that was said is in $log."
  [[ -f $table ]] || head -n 1 <<<"$rows" >"$table"
  tail -n 1 <<<"$rows" >>"$table"
  DONE=$((DONE + 1))
  show_progress 'solves' "$DONE" "$RUNS"
}

# measure_ours TABLE SOLVER NAME FILE GUESS
measure_ours() {
  measure "$1" "$GRAPH_PROGRAM" solve "$4" --solver "$2" --name "$3" --guess "$5"
}

# measure_peer TABLE SOLVER NAME FILE GUESS
measure_peer() {
  local guessed=$GUESSED/$3_$5.g2o
  [[ -f $guessed ]] || "$GRAPH_PROGRAM" guess "$4" --guess "$5" --out "$guessed"
  measure "$1" "$PEERS/bin/python" "$OMEGA_SLAM_ROOT/benchmark/peers/pose_graph_peers.py" \
    "$guessed" --program "$GRAPH_PROGRAM" --solver "$2" --name "$3" --guess "$5"
}

# solve_graph NAME: by every solver from every guess.
solve_graph() {
  local name=$1 guess solver
  measure_ours solves ours "$name" "${GRAPHS[$name]}" best
  for guess in "${GUESSES[@]}"; do
    for solver in "${OUR_SOLVERS[@]}"; do
      measure_ours solves "$solver" "$name" "${GRAPHS[$name]}" "$guess"
    done
    for solver in "${PEER_SOLVERS[@]}"; do
      measure_peer solves "$solver" "$name" "${GRAPHS[$name]}" "$guess"
    done
  done
}

# solve_grid POSES: by ours and the fastest peer.
solve_grid() {
  local name=grid_$1 file=$GUESSED/grid_$1.g2o guess
  [[ -f $file ]] || "$GRAPH_PROGRAM" grid --poses "$1" --out "$file"
  for guess in best tree; do measure_ours scaling ours "$name" "$file" "$guess"; done
  ((${#PEER_SOLVERS[@]} == 0)) || measure_peer scaling g2o_gn "$name" "$file" tree
}

# play_graph NAME: pose by pose, by ours and iSAM2.
play_graph() {
  local file=$GUESSED/$1_odometry.g2o
  measure online "$GRAPH_PROGRAM" online "${GRAPHS[$1]}" --name "$1" \
    --times "$TABLES/online_ours_$1.csv"
  ((${#PEER_SOLVERS[@]} > 0)) || return 0
  measure online "$PEERS/bin/python" "$OMEGA_SLAM_ROOT/benchmark/peers/isam2_online.py" "$file" \
    --program "$GRAPH_PROGRAM" --name "$1" --times "$TABLES/online_isam2_$1.csv"
}

# run_graph_experiments ROUNDS POSES...: with grids of so many poses.
run_graph_experiments() {
  local rounds=$1 round name poses played=()
  shift
  new_tables
  rm -rf "$GUESSED"
  mkdir -p "$GUESSED"
  PROCESSOR=$(taskset --cpu-list --pid $$ | sed 's/.*[^0-9]//') # the last that we may use
  ! built_with_ceres || OUR_SOLVERS+=(ceres)
  ((${#PEER_SOLVERS[@]} == 0)) || describe_peers >"$TABLES/peers.csv"
  for name in "${!GRAPHS[@]}"; do [[ $PLAYED != *" $name "* ]] || played+=("$name"); done
  local both=$((${#PEER_SOLVERS[@]} > 0 ? 1 : 0)) # ours and peers
  RUNS=$((rounds * (${#GRAPHS[@]} *
    (1 + ${#GUESSES[@]} * (${#OUR_SOLVERS[@]} + ${#PEER_SOLVERS[@]})) + $# * (2 + both)) +
    ${#played[@]} * (1 + both)))
  for ((round = 0; round < rounds; ++round)); do
    for name in "${!GRAPHS[@]}"; do solve_graph "$name"; done
    for poses in "$@"; do solve_grid "$poses"; done
  done
  for name in "${played[@]}"; do play_graph "$name"; done
  finish_progress
}

# publish_graph OUT: the tables of this run alone, for not all runs have peers.
publish_graph() {
  rm -f "$1"/graph/*.csv
  publish graph "$1"
}
