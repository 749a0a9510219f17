#!/usr/bin/env bash
# What a catalogue costs on Spark, against the command: time and CPU seconds of `jsm encode --site` in two processes
# with a thread each, and of the job with one and with two executors of one core. After
#     mvn -q -Pspark -DskipTests package
# in the project's folder: server/spark/src/bench/catalogue.sh [MODELS [FOLDER]]
set -euo pipefail
cd "$(dirname "$0")/../../../.."
models=${1:-2000}
folder=${2:-$(mktemp -d)}
java=${JAVA_HOME:+$JAVA_HOME/bin/}java
# In place of an installation of Spark.
export SPARK_SCALA_VERSION=2.13 SPARK_HOME=$folder/spark
mkdir -p "$SPARK_HOME/jars"
classes=$PWD/server/spark/target/classes:$PWD/server/spark/target/test-classes:$(cat server/spark/target/bench.classpath)
opens=()
for package in lang lang.invoke lang.reflect io net nio util util.concurrent util.concurrent.atomic; do
    opens+=("--add-opens=java.base/java.$package=ALL-UNNAMED")
done
for package in jdk.internal.ref sun.nio.ch sun.nio.cs sun.security.action sun.util.calendar; do
    opens+=("--add-opens=java.base/$package=ALL-UNNAMED")
done

# Prints a line of a table; processes that end within count, with theirs.
TIMEFORMAT='%R %U %S'
row() {
    local name=$1 times
    shift
    times=$({ time "$@" >"$folder/out.txt" 2>"$folder/err.txt"; } 2>&1) || { tail -20 "$folder/err.txt"; exit 1; }
    awk -v name="$name" -v models="$models" '{
        printf "| %s | %.0f | %.0f | %.1f |\n", name, 60 * models / $1, $2 + $3, $1 }' <<<"$times"
}

by_command() {
    local half process processes=()
    for half in a b; do
        "$java" -Xmx1g -XX:+UseParallelGC -XX:ParallelGCThreads=1 -jar server/app/target/jsm.jar \
            encode "$folder/models/$half" --site "$folder/command-$half" --threads 1 --quiet &
        processes+=($!)
    done
    # Without a number wait forgets how they ended.
    for process in "${processes[@]}"; do wait "$process"; done
}

spark() {
    "$java" -Xmx1g "${opens[@]}" -Dspark.master="local-cluster[$1,1,1024]" -Dspark.ui.enabled=false \
        -Dspark.driver.host=127.0.0.1 -Dspark.executor.extraClassPath="$classes" \
        -Dspark.executor.extraJavaOptions='-XX:+UseParallelGC -XX:ParallelGCThreads=1' \
        -cp "$classes" org.jsmesh.spark.EncodeCatalogue "$folder/models" --site "$folder/spark-$1"
}

"$java" -cp "$classes" org.jsmesh.spark.BenchModels "$folder/models" "$models"
uptime
echo "| | models a minute | CPU seconds | seconds |"
echo "|---|--:|--:|--:|"
row "\`jsm encode --site\`, 2 processes" by_command
row "Spark, 1 executor" spark 1
row "Spark, 2 executors" spark 2
row "Spark, 2 executors, nothing has changed" spark 2
uptime
rm -rf "$SPARK_HOME" "$folder/models" "$folder"/command-? "$folder"/spark-? "$folder"/spark-?-report "$folder"/out.txt "$folder"/err.txt
