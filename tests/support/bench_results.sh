# SPDX-License-Identifier: MIT
# Bench results for shell tests; they source it.

# bench_sample KEY CONFIG SAMPLES MS RMSE [FAILURE [MOTION]]: one line of results. MOTION is its rms in a pan.
bench_sample() {
    local key=$1 config=$2 samples=$3 ms=$4 rmse=$5 failure=${6:-} motion=${7:-}
    printf '{"key":"%s","failure":"%s","config":"%s","overrides":["samples=%s"],"family":"%s",' \
        "$key" "$failure" "$config" "$samples" "$config"
    printf '"scene":"room","camera":"","extent":{"width":960,"height":540},"radius":1,"rays":256,'
    printf '"radius_px":80,"samples":%s,"triangles":1000,"device":"device A","software":true,' "$samples"
    printf '"version":"0.1.0","error":{"rmse":%s,"bias":0.01,"p99":0.2,"pattern":0.01,"rmse_fit":%s,' "$rmse" "$rmse"
    printf '"power_fit":1,"pixels":500000},"error_without_ao":0.2,'
    printf '"clock":"wall","repeats":9,"total":{"median":%s,"q1":%s,"q3":%s},' "$ms" "$ms" "$ms"
    printf '"cost":{"median":%s,"q1":%s,"q3":%s},' "$ms" "$ms" "$ms"
    printf '"passes":[{"name":"ao","ms":{"median":%s,"q1":%s,"q3":%s}}],' "$ms" "$ms" "$ms"
    printf '"ratio_learnopengl":%s,"texture_bytes":1e6,"bytes_read":2e6,' "$ms"
    printf '"bytes_written":1e6,"ao_picture":"%s.png","ground_truth_picture":"ground_truth.png",' "$key"
    printf '"difference_picture":"%s.png"' "$key"
    if [[ -n $motion ]]; then
        printf ',"motion":{"paths":{"pan":{"rms":%s,"p99":0.05,"p999":0.25,"truth":0.01,"rmse":0.07,' "$motion"
        printf '"changes":1000}},"settled_after":0,"uncovered":[{"frames":1,"rmse":0.3}],"uncovered_rest":0.2,'
        printf '"uncovered_pixels":9}'
    fi
    printf '}\n'
}

# A sweep of two configs and a failure in results.jsonl, with pictures of one pixel beside it.
write_results() {
    {
        bench_sample a4 quick 4 1.0 0.10
        bench_sample a16 quick 16 2.0 0.09
        bench_sample b4 fine 4 3.0 0.05 '' 0.0123
        bench_sample b16 fine 16 6.0 0.04
        bench_sample c4 '<b>slow</b>' 4 7.0 0.06
        bench_sample d4 broken 4 0 0 'the shader does not link'
    } >results.jsonl
    local name
    for name in a4 a16 b4 b16 c4 d4 ground_truth; do
        base64 -d >"$name.png" <<<'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTwmiQAAAABJRU5ErkJggg=='
    done
}
