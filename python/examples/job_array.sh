#!/bin/bash
# A million drives with gradients in 20 parts, as a job array of Slurm: sbatch job_array.sh
# Then: longdrive sweep --check drives. It lists the missing parts, such as 3 and 17 to 20; write
# them with sbatch --array=3,17-20 job_array.sh
#SBATCH --array=1-20
#SBATCH --cpus-per-task=1
longdrive sweep tour-average --over club.loft=5deg..15deg:1000 --over swing.speed=80mph..130mph:1000 \
  --outcomes carry,lateral --gradient --instructions avx2 --threads 1 -o drives --part "$SLURM_ARRAY_TASK_ID/20"
