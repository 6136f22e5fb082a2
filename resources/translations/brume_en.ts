<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>brume</name>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n value</numerusform>
            <numerusform>%n values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move keyframe(s) of %1</source>
        <translation>
            <numerusform>Move keyframe of %1</numerusform>
            <numerusform>Move keyframes of %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete keyframe(s) of %1</source>
        <translation>
            <numerusform>Delete keyframe of %1</numerusform>
            <numerusform>Delete keyframes of %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n Gaussian(s)</source>
        <translation>
            <numerusform>%n Gaussian</numerusform>
            <numerusform>%n Gaussians</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%1 of %n frame(s) are written)</source>
        <translation>
            <numerusform>(%1 of %n frame is written)</numerusform>
            <numerusform>(%1 of %n frames are written)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n render(s) are not finished. Stop them? At the next start they are in the queue.</source>
        <translation>
            <numerusform>%n render is not finished. Stop it? At the next start it is in the queue.</numerusform>
            <numerusform>%n renders are not finished. Stop them? At the next start they are in the queue.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) already exist, “%1” to “%2”. Replace them?</source>
        <translation>
            <numerusform>%n file already exists, “%1” to “%2”. Replace it?</numerusform>
            <numerusform>%n files already exist, “%1” to “%2”. Replace them?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mesh(es)</source>
        <translation>
            <numerusform>%n mesh</numerusform>
            <numerusform>%n meshes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n node</numerusform>
            <numerusform>%n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n file</numerusform>
            <numerusform>%n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n file(s)</source>
        <translation>
            <numerusform>Import %n file</numerusform>
            <numerusform>Import %n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 Gaussian(s)</source>
        <translation>
            <numerusform>%1 Gaussian</numerusform>
            <numerusform>%1 Gaussians</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n Gaussian(s) on this ray</source>
        <translation>
            <numerusform>%n Gaussian on this ray</numerusform>
            <numerusform>%n Gaussians on this ray</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n slice(s)</source>
        <translation>
            <numerusform>%n slice</numerusform>
            <numerusform>%n slices</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 path(s), noise %2</source>
        <translation>
            <numerusform>%1 path, noise %2</numerusform>
            <numerusform>%1 paths, noise %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 path(s), denoised</source>
        <translation>
            <numerusform>%1 path, denoised</numerusform>
            <numerusform>%1 paths, denoised</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 path(s)</source>
        <translation>
            <numerusform>%1 path</numerusform>
            <numerusform>%1 paths</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>all orders, converged to %1 in %n sweep(s)</source>
        <translation>
            <numerusform>all orders, converged to %1 in %n sweep</numerusform>
            <numerusform>all orders, converged to %1 in %n sweeps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, with %n file(s) from outside the scene's folder</source>
        <translation>
            <numerusform>, with %n file from outside the scene's folder</numerusform>
            <numerusform>, with %n files from outside the scene's folder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Export cancelled after %n file(s)</source>
        <translation>
            <numerusform>Export cancelled after %n file</numerusform>
            <numerusform>Export cancelled after %n files</numerusform>
        </translation>
    </message>
</context>
</TS>
