# Runs the experiments on false loops. Needs common.sh, run_experiments.sh and
# run_graph_experiments.sh, whose graphs it takes.

OUTLIER_PROGRAM=$EXPERIMENTS_TREE/benchmark/outlier_experiments
OUTLIER_GRAPHS=intel,manhattan,CSAIL,MIT,city10000
COMPARED=' intel manhattan ' # graphs on which kernels are tried, too
KERNELS=(scaling graduated cauchy huber)

# spoil NAME SOLVER SEEDS: adds the rows of all trials to the table.
spoil() {
  local table=$TABLES/outliers.csv log=$LOG_DIR/experiment_graph_outliers.log rows
  rows=$(OMP_NUM_THREADS=1 "$OUTLIER_PROGRAM" "${GRAPHS[$1]}" --name "$1" --solver "$2" \
    --seeds "$3" 2>>"$log") || die "$2 has failed on $1." "All that was said is in $log."
  [[ -f $table ]] || head -n 1 <<<"$rows" >"$table"
  tail -n +2 <<<"$rows" >>"$table"
  DONE=$((DONE + 1))
  show_progress 'sweeps' "$DONE" "$RUNS"
}

# run_outlier_experiments SEEDS
run_outlier_experiments() {
  local seeds=$1 name solver
  new_tables
  for name in "${!GRAPHS[@]}"; do
    RUNS=$((RUNS + 2))
    [[ $COMPARED != *" $name "* ]] || RUNS=$((RUNS + ${#KERNELS[@]}))
  done
  for name in "${!GRAPHS[@]}"; do
    spoil "$name" doubt "$seeds"
    if [[ $COMPARED == *" $name "* ]]; then
      for solver in plain "${KERNELS[@]}"; do spoil "$name" "$solver" "$seeds"; done
    else
      spoil "$name" plain 0 # without false loops, for its time
    fi
  done
  finish_progress
}
