// Each slider tells its pair where to cut the picture that lies on top.
for (const pair of document.querySelectorAll(".pair")) {
    const slider = pair.querySelector("input");
    const cut = () => pair.style.setProperty("--split", slider.value + "%");
    slider.addEventListener("input", cut);
    // A browser may bring back the value of an earlier visit.
    cut();
}
