"""Programs and benchmarks; `make bench` runs the files named bench_*."""
