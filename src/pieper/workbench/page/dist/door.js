import{K as t}from"./chunk-LLBWXIPN.js";t();var e=()=>import("./app.js");document.readyState==="complete"?e():addEventListener("load",e,{once:!0});
