#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles the device's kernel with nvcc, and looks in the result for arithmetic that would change bits: products that
# are fused with sums, estimates, and subnormal numbers that count as 0.
#
#   compile.sh CORE NVCC FLAG…      CORE is the folder of sources
set -euo pipefail
export LC_ALL=C
core=$1 nvcc=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$nvcc" "${@:3}" -arch=compute_90 --ptx -o "$folder/kernel.ptx" "$core/device/cuda/cuda_runner.cu"
if grep -nE '\b(fma|mad)\.(rn|rz|rm|rp|f32|f64)|\.approx|\.ftz|\.full' "$folder/kernel.ptx"; then
    echo 'compile: these instructions do not round as the native engine does'
    exit 1
fi
for operation in sqrt.rn.f32 div.rn.f32 rcp.rn.f32 div.rn.f64; do
    grep -qF "$operation" "$folder/kernel.ptx" || { echo "compile: no $operation, where there should be some"; exit 1; }
done
"$(dirname "$nvcc")/ptxas" -arch=sm_90 -v -o "$folder/kernel.cubin" "$folder/kernel.ptx"
echo 'compile: PASS'
