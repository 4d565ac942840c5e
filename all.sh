for f in /work/main/configs/*.toml; do timeout 200 /tmp/venv/bin/python /tmp/p5/collect.py $f >> /tmp/p5/all.jsonl 2>>/tmp/p5/err.txt; done
echo done > /tmp/p5/done
