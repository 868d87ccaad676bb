#!/bin/sh
#SBATCH --array=1-4
#SBATCH --output=shard-%a.log
# An audit as a job array: each task is a shard with a store of its own; SHOP, STORES and OWLINT come with `sbatch --export`.
# Status 1 says that there are findings, which is no failure of the job.
"$OWLINT" audit "$SHOP" -q --shard "$SLURM_ARRAY_TASK_ID/4" --store "$STORES/part$SLURM_ARRAY_TASK_ID.db" || [ $? -eq 1 ]
