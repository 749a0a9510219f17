# c
Vertex 1 0 0 0 {normal=(0 0 1) sharp}
Vertex 5 1 0 0 {uv=(0.5 0) rgb=(1 0 0)}
Vertex 3 0 1 0
Vertex 4 .3 .3 0
Face 7 1 5 3 {rgb=(1 0.5 0) matid=3}
Face 9 1 5 4 3 {mat="a b"}
Corner 1 7 {normal=(1 0 0)}
Corner 99 7 {normal=(1 0 0)}
