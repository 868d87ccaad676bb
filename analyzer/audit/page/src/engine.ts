// Graphviz, which lays the graphs out and draws them. Started only when one is looked at.
export { instance } from "@viz-js/viz";
