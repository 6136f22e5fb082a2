<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>brume</name>
    <message>
        <source>Surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>Surface “%1”…</source>
        <translation>Oberfläche „%1“…</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>Selected Fog “%1”…</source>
        <translation>Gewählter Nebel „%1“…</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Lichter</translation>
    </message>
    <message>
        <source>Light “%1”…</source>
        <translation>Licht „%1“…</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Camera “%1”…</source>
        <translation>Kamera „%1“…</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Brush “%1”…</source>
        <translation>Pinsel „%1“…</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>No assets yet. Save what is selected, or put meshes, volumes and scenes into the folder.</source>
        <translation>Noch keine Assets. Speichern Sie, was gewählt ist, oder legen Sie Netze, Volumen und Szenen in den Ordner.</translation>
    </message>
    <message>
        <source>No asset is of this kind and has this in its name.</source>
        <translation>Kein Asset ist von dieser Art und hat dies im Namen.</translation>
    </message>
    <message>
        <source>Shows assets whose names have this</source>
        <translation>Zeigt Assets, in deren Namen dies vorkommt</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>The kind of assets that are shown</source>
        <translation>Die Art der Assets, die gezeigt werden</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Saves what is selected, the camera or the brush as an asset</source>
        <translation>Speichert, was gewählt ist, die Kamera oder den Pinsel als Asset</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Opens your folder of assets. What is put into it is listed here, and so is the folder “assets” beside the scene</source>
        <translation>Öffnet Ihren Ordner der Assets. Was darin liegt, steht hier, ebenso der Ordner „assets“ neben der Szene</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Drag an asset into a view: it lands on what is under the mouse</source>
        <translation>Ziehen Sie ein Asset in eine Ansicht: Es landet auf dem, was unter der Maus ist</translation>
    </message>
    <message>
        <source>Assets</source>
        <translation>Assets</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Show in Its Folder</source>
        <translation>In seinem Ordner zeigen</translation>
    </message>
    <message>
        <source>Move to the Trash</source>
        <translation>In den Papierkorb verschieben</translation>
    </message>
    <message>
        <source>%1 cannot be moved to the trash</source>
        <translation>%1 lässt sich nicht in den Papierkorb verschieben</translation>
    </message>
    <message>
        <source>An emitter cannot be saved as an asset</source>
        <translation>Ein Emitter kann nicht als Asset gespeichert werden</translation>
    </message>
    <message>
        <source>Save as Asset</source>
        <translation>Als Asset speichern</translation>
    </message>
    <message>
        <source>Assets (*%1)</source>
        <translation>Assets (*%1)</translation>
    </message>
    <message>
        <source>Saved as the asset %1</source>
        <translation>Als Asset %1 gespeichert</translation>
    </message>
    <message>
        <source>The scene would have %1 Gaussians, including emitters and sequences; allowed: %2</source>
        <translation>Die Szene hätte %1 Gaußfunktionen, einschließlich Emittern und Sequenzen; erlaubt: %2</translation>
    </message>
    <message>
        <source>Add sun</source>
        <translation>Sonne hinzufügen</translation>
    </message>
    <message>
        <source>Set anisotropy</source>
        <translation>Anisotropie setzen</translation>
    </message>
    <message>
        <source>More than %1: make the spacing larger.</source>
        <translation>Mehr als %1: Vergrößern Sie den Abstand.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Ground Mist</source>
        <translation>Bodennebel</translation>
    </message>
    <message>
        <source>A shallow, patchy layer that lies on the ground in view</source>
        <translation>Eine flache, fleckige Schicht, die auf dem sichtbaren Boden liegt</translation>
    </message>
    <message>
        <source>&amp;Steam</source>
        <translation>Dampf</translation>
    </message>
    <message>
        <source>A thin white plume from the ground</source>
        <translation>Eine dünne weiße Fahne vom Boden aus</translation>
    </message>
    <message>
        <source>S&amp;moke Column</source>
        <translation>Rauchsäule</translation>
    </message>
    <message>
        <source>A dense grey column that bends with the wind</source>
        <translation>Eine dichte graue Säule, die sich im Wind neigt</translation>
    </message>
    <message>
        <source>&amp;Haze</source>
        <translation>Dunst</translation>
    </message>
    <message>
        <source>Thin even fog everywhere: more homogeneous density</source>
        <translation>Dünner gleichmäßiger Nebel überall: mehr homogene Dichte</translation>
    </message>
    <message>
        <source>&amp;Dust</source>
        <translation>Staub</translation>
    </message>
    <message>
        <source>A thin, uneven, ochre cloud above the ground in view</source>
        <translation>Eine dünne, ungleichmäßige, ockerfarbene Wolke über dem sichtbaren Boden</translation>
    </message>
    <message>
        <source>God &amp;Rays</source>
        <translation>Lichtstrahlen</translation>
    </message>
    <message>
        <source>Haze for beams of light, and a sun from beyond if there is none</source>
        <translation>Dunst für Lichtstrahlen und eine Sonne von jenseits, falls es keine gibt</translation>
    </message>
    <message>
        <source>Add fog box</source>
        <translation>Nebelquader hinzufügen</translation>
    </message>
    <message>
        <source>Add fog sphere</source>
        <translation>Nebelkugel hinzufügen</translation>
    </message>
    <message>
        <source>Add height fog</source>
        <translation>Höhennebel hinzufügen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Nothing to paste: %1</source>
        <translation>Nichts einzufügen: %1</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Add group</source>
        <translation>Gruppe hinzufügen</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>%1 gruppieren</translation>
    </message>
    <message>
        <source>Ungroup %1</source>
        <translation>Gruppierung von %1 aufheben</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <translation>%1 nach %2 verschieben</translation>
    </message>
    <message>
        <source>Move %1 out of groups</source>
        <translation>%1 aus Gruppen herausnehmen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Move %1 into %2</source>
        <translation>%1 in %2 verschieben</translation>
    </message>
    <message>
        <source>Move %1 out of its group</source>
        <translation>%1 aus der Gruppe herausnehmen</translation>
    </message>
    <message>
        <source>The active group “%1” is locked: nothing is added to it. Unlock it or choose another in the outliner.</source>
        <translation>Die aktive Gruppe „%1“ ist gesperrt: Nichts wird ihr hinzugefügt. Entsperren Sie sie, oder wählen Sie im Outliner eine andere.</translation>
    </message>
    <message>
        <source>The active group “%1” is hidden: nothing is added to it. Show it or choose another in the outliner.</source>
        <translation>Die aktive Gruppe „%1“ ist ausgeblendet: Nichts wird ihr hinzugefügt. Blenden Sie sie ein, oder wählen Sie im Outliner eine andere.</translation>
    </message>
    <message>
        <source>Add Gaussian</source>
        <translation>Gaußfunktion hinzufügen</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Set homogeneous density to %1</source>
        <translation>Homogene Dichte auf %1 setzen</translation>
    </message>
    <message>
        <source>Set %1 of %2 to %3</source>
        <translation>%1 von %2 auf %3 setzen</translation>
    </message>
    <message>
        <source>Set colours of %1</source>
        <translation>Farben von %1 setzen</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>%1 von %2 ändern</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>Delete %1, keep its fog</source>
        <translation>%1 löschen, Nebel behalten</translation>
    </message>
    <message>
        <source>Deselect all</source>
        <translation>Auswahl aufheben</translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>%1 auswählen</translation>
    </message>
    <message>
        <source>Simplify %1</source>
        <translation>%1 vereinfachen</translation>
    </message>
    <message>
        <source>A scene has %1 cameras at most.</source>
        <translation>Eine Szene hat höchstens %1 Kameras.</translation>
    </message>
    <message>
        <source>Add camera %1</source>
        <translation>Kamera %1 hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate camera %1</source>
        <translation>Kamera %1 duplizieren</translation>
    </message>
    <message>
        <source>Use camera %1</source>
        <translation>Kamera %1 verwenden</translation>
    </message>
    <message>
        <source>Rename camera %1 to %2</source>
        <translation>Kamera %1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>A scene keeps one camera.</source>
        <translation>Eine Szene behält eine Kamera.</translation>
    </message>
    <message>
        <source>Delete camera %1</source>
        <translation>Kamera %1 löschen</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>Move camera</source>
        <translation>Kamera verschieben</translation>
    </message>
    <message>
        <source>emitter %1</source>
        <translation>Emitter %1</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Set sky</source>
        <translation>Himmel setzen</translation>
    </message>
    <message>
        <source>Move sun</source>
        <translation>Sonne verschieben</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n Wert</numerusform>
            <numerusform>%n Werten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move keyframe(s) of %1</source>
        <translation>
            <numerusform>Keyframe von %1 verschieben</numerusform>
            <numerusform>Keyframes von %1 verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Set keyframe of %1</source>
        <translation>Keyframe von %1 setzen</translation>
    </message>
    <message numerus="yes">
        <source>Delete keyframe(s) of %1</source>
        <translation>
            <numerusform>Keyframe von %1 löschen</numerusform>
            <numerusform>Keyframes von %1 löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Set tangent of %1</source>
        <translation>Tangente von %1 setzen</translation>
    </message>
    <message>
        <source>Paste keyframes of %1</source>
        <translation>Keyframes von %1 einfügen</translation>
    </message>
    <message>
        <source>Make keyframe of %1 smooth</source>
        <translation>Keyframe von %1 glätten</translation>
    </message>
    <message>
        <source>Make keyframe of %1 linear</source>
        <translation>Keyframe von %1 linear machen</translation>
    </message>
    <message>
        <source>Make keyframe of %1 constant</source>
        <translation>Keyframe von %1 konstant machen</translation>
    </message>
    <message>
        <source>Make tangents of %1 automatic</source>
        <translation>Tangenten von %1 automatisch machen</translation>
    </message>
    <message>
        <source>Align tangents of %1</source>
        <translation>Tangenten von %1 ausrichten</translation>
    </message>
    <message>
        <source>Make tangents of %1 free</source>
        <translation>Tangenten von %1 frei machen</translation>
    </message>
    <message>
        <source>light %1</source>
        <translation>Licht %1</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>Moon</source>
        <translation>Mond</translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation>Scheinwerfer</translation>
    </message>
    <message>
        <source>Stage Spot</source>
        <translation>Bühnenspot</translation>
    </message>
    <message>
        <source>Street Lamp</source>
        <translation>Straßenlaterne</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Candle</source>
        <translation>Kerze</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>A node is part of its file. Select its surface.</source>
        <translation>Ein Knoten ist Teil seiner Datei. Wählen Sie seine Oberfläche aus.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Turn on %1</source>
        <translation>%1 einschalten</translation>
    </message>
    <message>
        <source>Turn off %1</source>
        <translation>%1 ausschalten</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 einblenden</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>%1 sperren</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>%1 entsperren</translation>
    </message>
    <message>
        <source>Set size of picture</source>
        <translation>Bildgröße setzen</translation>
    </message>
    <message>
        <source>Autosave failed: %1</source>
        <translation>Automatisches Sichern fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>%1 must be %2</source>
        <translation>%1 muss sein: %2</translation>
    </message>
    <message>
        <source>%1, not %2.</source>
        <translation>%1, nicht %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n Gaussian(s)</source>
        <translation>
            <numerusform>%n Gaußfunktion</numerusform>
            <numerusform>%n Gaußfunktionen</numerusform>
        </translation>
    </message>
    <message>
        <source>Centre X</source>
        <translation>Zentrum X</translation>
    </message>
    <message>
        <source>Centre Y</source>
        <translation>Zentrum Y</translation>
    </message>
    <message>
        <source>Centre Z</source>
        <translation>Zentrum Z</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Albedo</source>
        <translation>Albedo</translation>
    </message>
    <message>
        <source>Emission</source>
        <translation>Emission</translation>
    </message>
    <message>
        <source>Radius X</source>
        <translation>Radius X</translation>
    </message>
    <message>
        <source>Radius Y</source>
        <translation>Radius Y</translation>
    </message>
    <message>
        <source>Radius Z</source>
        <translation>Radius Z</translation>
    </message>
    <message>
        <source>Rotation X</source>
        <translation>Rotation X</translation>
    </message>
    <message>
        <source>Rotation Y</source>
        <translation>Rotation Y</translation>
    </message>
    <message>
        <source>Rotation Z</source>
        <translation>Rotation Z</translation>
    </message>
    <message>
        <source>Elongation</source>
        <translation>Streckung</translation>
    </message>
    <message>
        <source>Emitter %1</source>
        <translation>Emitter %1</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>turned, degrees</source>
        <translation>Drehung, Grad</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Homogeneous density</source>
        <translation>Homogene Dichte</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>Frame %1: %2</source>
        <translation>Frame %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>(%1 of %n frame(s) are written)</source>
        <translation>
            <numerusform>(%1 von %n Frame ist geschrieben)</numerusform>
            <numerusform>(%1 von %n Frames sind geschrieben)</numerusform>
        </translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Rendern</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Renders cannot be kept for the next session: %1</source>
        <translation>Gerenderte Bilder können nicht für die nächste Sitzung behalten werden: %1</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Gaussians</source>
        <translation>Gaußfunktionen</translation>
    </message>
    <message>
        <source>Gaussian splats</source>
        <translation>Gauß-Splats</translation>
    </message>
    <message>
        <source>Lit splats</source>
        <translation>Beleuchtete Splats</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>Webseite</translation>
    </message>
    <message>
        <source>USD stage</source>
        <translation>USD-Stage</translation>
    </message>
    <message>
        <source>half precision</source>
        <translation>halbe Genauigkeit</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Erster Frame</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letzter Frame</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export Medium</source>
        <translation>Medium exportieren</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>All Gaussians</source>
        <translation>Alle Gaußfunktionen</translation>
    </message>
    <message>
        <source>Selected %1</source>
        <translation>Ausgewählt: %1</translation>
    </message>
    <message>
        <source>Lit splats are lit as they are among the others</source>
        <translation>Beleuchtete Splats sind so beleuchtet, wie sie es unter den anderen sind</translation>
    </message>
    <message>
        <source>Voxel size, u</source>
        <translation>Voxelgröße, u</translation>
    </message>
    <message>
        <source>As opaque as fog along</source>
        <translation>So undurchsichtig wie Nebel entlang</translation>
    </message>
    <message>
        <source>-y (turned by half about z)</source>
        <translation>-y (halb um z gedreht)</translation>
    </message>
    <message>
        <source>Most viewers of .ply splats expect -y, as captures have it</source>
        <translation>Die meisten Betrachter von .ply-Splats erwarten -y, wie Aufnahmen es haben</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Hochachse</translation>
    </message>
    <message>
        <source>The light is written as it is displayed: in stops, as the view's</source>
        <translation>Das Licht wird so geschrieben, wie es angezeigt wird: in Blendenstufen wie in der Ansicht</translation>
    </message>
    <message>
        <source>Exposure, stops</source>
        <translation>Belichtung, Blendenstufen</translation>
    </message>
    <message>
        <source>little</source>
        <translation>wenig</translation>
    </message>
    <message>
        <source>The file must end in %1.</source>
        <translation>Die Datei muss auf %1 enden.</translation>
    </message>
    <message>
        <source>The exposure must be %1.</source>
        <translation>Die Belichtung muss sein: %1.</translation>
    </message>
    <message>
        <source>The voxel size must be greater than 0.</source>
        <translation>Die Voxelgröße muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>More than 2 GB: use larger voxels.</source>
        <translation>Mehr als 2 GB: Verwenden Sie größere Voxel.</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>low</source>
        <translation>niedrig</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>%1 of %2 frames</source>
        <translation>%1 von %2 Bildern</translation>
    </message>
    <message>
        <source>%1 per frame</source>
        <translation>%1 je Bild</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>%1 %, %2 left</source>
        <translation>%1 %, noch %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>, frames %1 to %2</source>
        <translation>, Frames %1 bis %2</translation>
    </message>
    <message>
        <source>Render queue</source>
        <translation>Renderliste</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorität</translation>
    </message>
    <message>
        <source>Renders go on while you edit, each of the scene as it was when it was added. Drag those that wait to where they are to be rendered</source>
        <translation>Gerendert wird weiter, während Sie arbeiten, jedes Mal die Szene, wie sie beim Hinzufügen war. Wartende lassen sich dorthin ziehen, wo sie an der Reihe sein sollen</translation>
    </message>
    <message>
        <source>Nothing to render. F12 renders what the scene's camera sees, Ctrl+F12 the animation; both go on while you edit.</source>
        <translation>Nichts zu rendern. F12 rendert, was die Kamera der Szene sieht, Strg+F12 die Animation; beide laufen weiter, während Sie arbeiten.</translation>
    </message>
    <message>
        <source>Of those that wait, the first with the highest priority is rendered next</source>
        <translation>Von den Wartenden wird als Nächstes der erste Eintrag mit der höchsten Priorität gerendert</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Shows its last picture in the picture viewer</source>
        <translation>Zeigt das letzte Bild im Bildbetrachter</translation>
    </message>
    <message>
        <source>Opens the folder of its files</source>
        <translation>Öffnet den Ordner der Dateien</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ends it; complete pictures stay</source>
        <translation>Beendet es; fertige Bilder bleiben</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Renders, of the same scene, what failed or was not rendered yet</source>
        <translation>Rendert von derselben Szene, was fehlgeschlagen ist oder noch fehlt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes it off the list; its files stay</source>
        <translation>Nimmt es aus der Liste; die Dateien bleiben</translation>
    </message>
    <message>
        <source>Renders it before the one above</source>
        <translation>Rendert es vor dem darüber</translation>
    </message>
    <message>
        <source>Renders it after the one below</source>
        <translation>Rendert es nach dem darunter</translation>
    </message>
    <message>
        <source>Render queue, %1 left</source>
        <translation>Renderliste, noch %1</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message numerus="yes">
        <source>%n render(s) are not finished. Stop them? At the next start they are in the queue.</source>
        <translation>
            <numerusform>%n Rendervorgang ist nicht fertig. Anhalten? Beim nächsten Start steht er in der Liste.</numerusform>
            <numerusform>%n Rendervorgänge sind nicht fertig. Anhalten? Beim nächsten Start stehen sie in der Liste.</numerusform>
        </translation>
    </message>
    <message>
        <source>Unfinished Renders</source>
        <translation>Rendern nicht fertig</translation>
    </message>
    <message>
        <source>Keep Rendering</source>
        <translation>Weiter rendern</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Render of an earlier session</source>
        <translation>Gerendert in einer früheren Sitzung</translation>
    </message>
    <message>
        <source>“%1” in the queue has yet to write %2. Name another file, or cancel that one.</source>
        <translation>„%1“ in der Liste soll %2 erst noch schreiben. Nennen Sie eine andere Datei, oder brechen Sie jenen Eintrag ab.</translation>
    </message>
    <message>
        <source>“%1” already exists. Replace it?</source>
        <translation>„%1“ gibt es schon. Ersetzen?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) already exist, “%1” to “%2”. Replace them?</source>
        <translation>
            <numerusform>%n Datei gibt es schon, „%1“ bis „%2“. Ersetzen?</numerusform>
            <numerusform>%n Dateien gibt es schon, „%1“ bis „%2“. Ersetzen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace Files</source>
        <translation>Dateien ersetzen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Brume scenes (*.brume);;All files (*)</source>
        <translation>Brume-Szenen (*.brume);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open Scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Changed on Disk</source>
        <translation>Auf der Platte geändert</translation>
    </message>
    <message>
        <source>“%1” has been changed by another program. Overwriting it discards that change.</source>
        <translation>„%1“ wurde von einem anderen Programm geändert. Überschreiben verwirft diese Änderung.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Find %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>Files of this type (*%1);;All files (*)</source>
        <translation>Dateien dieser Art (*%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save Scene As</source>
        <translation>Szene speichern unter</translation>
    </message>
    <message>
        <source>untitled.brume</source>
        <translation>unbenannt.brume</translation>
    </message>
    <message>
        <source>“%1” is missing on disk. Save the scene there again?</source>
        <translation>„%1“ fehlt auf der Platte. Die Szene dort wieder speichern?</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Die Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>No scenes yet</source>
        <translation>Noch keine Szenen</translation>
    </message>
    <message>
        <source>refining</source>
        <translation>wird verfeinert</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>noise above %1 with all paths of a view: a rendered frame can have more</source>
        <translation>Rauschen über %1 mit allen Pfaden einer Ansicht: Ein gerendertes Bild kann mehr haben</translation>
    </message>
    <message>
        <source>error above %1: see Quality &gt; Auto, or Quality &gt; Reference</source>
        <translation>Fehler über %1: siehe Qualität &gt; Auto oder Qualität &gt; Referenz</translation>
    </message>
    <message>
        <source>%1 cannot be met here: allow more in Performance, or see Quality &gt; Reference</source>
        <translation>%1 ist hier nicht zu erreichen: Erlauben Sie unter Leistung mehr, oder siehe Qualität &gt; Referenz</translation>
    </message>
    <message>
        <source>Final Picture</source>
        <translation>Fertiges Bild</translation>
    </message>
    <message>
        <source>Airlight Only</source>
        <translation>Nur Luftlicht</translation>
    </message>
    <message>
        <source>Optical Depth</source>
        <translation>Optische Tiefe</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Aufwand</translation>
    </message>
    <message>
        <source>Error Against the Reference</source>
        <translation>Fehler gegen die Referenz</translation>
    </message>
    <message>
        <source>Path Traced</source>
        <translation>Path Tracing</translation>
    </message>
    <message>
        <source>Optical depth</source>
        <translation>Optische Tiefe</translation>
    </message>
    <message>
        <source>Pairs of Gaussian and ray per pixel</source>
        <translation>Paare von Gaußfunktion und Strahl pro Pixel</translation>
    </message>
    <message>
        <source>Error: waiting for the measurement</source>
        <translation>Fehler: wartet auf die Messung</translation>
    </message>
    <message>
        <source>Error, all orders of scattering</source>
        <translation>Fehler, alle Ordnungen der Streuung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>, %1 % of the pixels</source>
        <translation>, %1 % der Pixel</translation>
    </message>
    <message>
        <source>Path traced: waiting for the first paths</source>
        <translation>Path Tracing: wartet auf die ersten Pfade</translation>
    </message>
    <message>
        <source>Path traced, %1</source>
        <translation>Path Tracing, %1</translation>
    </message>
    <message>
        <source>The scene would have more than %1 lights.</source>
        <translation>Die Szene hätte mehr als %1 Lichter.</translation>
    </message>
    <message>
        <source>The scene would have more than %1 surfaces.</source>
        <translation>Die Szene hätte mehr als %1 Oberflächen.</translation>
    </message>
    <message>
        <source>The scene would have more than %1 groups.</source>
        <translation>Die Szene hätte mehr als %1 Gruppen.</translation>
    </message>
    <message>
        <source>The scene would have more than %1 cameras.</source>
        <translation>Die Szene hätte mehr als %1 Kameras.</translation>
    </message>
    <message>
        <source>%1 has changed, and has no meshes any more that a surface shows.</source>
        <translation>%1 hat sich geändert und hat keine Netze mehr, die eine Oberfläche zeigt.</translation>
    </message>
    <message>
        <source>Reload %1</source>
        <translation>%1 neu laden</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Temperature of 1, K</source>
        <translation>Temperatur von 1, K</translation>
    </message>
    <message>
        <source>Flames</source>
        <translation>Flammen</translation>
    </message>
    <message>
        <source>Flame extinction, 1/u</source>
        <translation>Extinktion der Flammen, 1/u</translation>
    </message>
    <message>
        <source>Flame temperature, K</source>
        <translation>Temperatur der Flammen, K</translation>
    </message>
    <message>
        <source>Where the volume has no temperature from 800 K</source>
        <translation>Wo das Volumen keine Temperatur ab 800 K hat</translation>
    </message>
    <message>
        <source>Emission scale</source>
        <translation>Emissionsfaktor</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatisch: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Write Gaussians to</source>
        <translation>Gaußfunktionen schreiben nach</translation>
    </message>
    <message>
        <source>Frames %1 to %2</source>
        <translation>Frames %1 bis %2</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message numerus="yes">
        <source>%n mesh(es)</source>
        <translation>
            <numerusform>%n Netz</numerusform>
            <numerusform>%n Netze</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n Knoten</numerusform>
            <numerusform>%n Knoten</numerusform>
        </translation>
    </message>
    <message>
        <source>Cameras (%1)</source>
        <translation>Kameras (%1)</translation>
    </message>
    <message>
        <source>Lights (%1)</source>
        <translation>Lichter (%1)</translation>
    </message>
    <message>
        <source>Candela and lux become W/sr and W/u² at 683 lm/W</source>
        <translation>Candela und Lux werden zu W/sr und W/u² bei 683 lm/W</translation>
    </message>
    <message>
        <source>become albedos</source>
        <translation>werden Albedos</translation>
    </message>
    <message>
        <source>As opaque as stored along</source>
        <translation>So undurchsichtig wie gespeichert entlang</translation>
    </message>
    <message>
        <source>z (turned about x)</source>
        <translation>z (um x gedreht)</translation>
    </message>
    <message>
        <source>As they are from all sides; else the fog has the medium's albedo</source>
        <translation>So, wie sie von allen Seiten sind; sonst hat der Nebel die Albedo des Mediums</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>The grid whose values are the density</source>
        <translation>Das Gitter, dessen Werte die Dichte sind</translation>
    </message>
    <message>
        <source>Density from grid</source>
        <translation>Dichte aus Gitter</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Size, u</source>
        <translation>Größe, u</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>First guessed from the size of the grid</source>
        <translation>Zuerst aus der Größe des Gitters geraten</translation>
    </message>
    <message>
        <source>Max Gaussians</source>
        <translation>Max. Gaußfunktionen</translation>
    </message>
    <message>
        <source>ellipsoids</source>
        <translation>Ellipsoide</translation>
    </message>
    <message>
        <source>balls</source>
        <translation>Kugeln</translation>
    </message>
    <message>
        <source>Half as many ellipsoids make the error of balls, in twice the time</source>
        <translation>Halb so viele Ellipsoide machen denselben Fehler wie Kugeln, in doppelter Zeit</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>kleinster</translation>
    </message>
    <message>
        <source>Max density error</source>
        <translation>Max. Fehler der Dichte</translation>
    </message>
    <message>
        <source>Density scale, 1/u</source>
        <translation>Dichtefaktor, 1/u</translation>
    </message>
    <message>
        <source>z (rotated to y)</source>
        <translation>z (nach y gedreht)</translation>
    </message>
    <message>
        <source>Takes about</source>
        <translation>Braucht etwa</translation>
    </message>
    <message>
        <source>The file has no grids.</source>
        <translation>Die Datei hat keine Gitter.</translation>
    </message>
    <message>
        <source>None of its grids can be a density; allowed: grids of one number per voxel.</source>
        <translation>Keines ihrer Gitter kann eine Dichte sein; erlaubt: Gitter mit einer Zahl pro Voxel.</translation>
    </message>
    <message>
        <source>%1 and %2 MB of memory</source>
        <translation>%1 und %2 MB Speicher</translation>
    </message>
    <message>
        <source>All supported files (*.vdb *.csv *.ply *.vtp *.vtu *.gltf *.glb *.fbx *.obj *.stl *.off *.exr *.hdr);;Scenes (*.gltf *.glb *.fbx *.obj);;Volumes (*.vdb);;Gaussians (*.csv *.ply *.vtp *.vtu *.gltf *.glb);;Meshes (*.obj *.ply *.stl *.off);;Environments (*.exr *.hdr);;All files (*)</source>
        <translation>Alle unterstützten Dateien (*.vdb *.csv *.ply *.vtp *.vtu *.gltf *.glb *.fbx *.obj *.stl *.off *.exr *.hdr);;Szenen (*.gltf *.glb *.fbx *.obj);;Volumen (*.vdb);;Gaußfunktionen (*.csv *.ply *.vtp *.vtu *.gltf *.glb);;Netze (*.obj *.ply *.stl *.off);;Umgebungen (*.exr *.hdr);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import a Sequence: Choose Any Frame</source>
        <translation>Sequenz importieren: einen beliebigen Frame wählen</translation>
    </message>
    <message>
        <source>Frames (*.vdb *.csv *.ply *.vtp *.vtu);;All files (*)</source>
        <translation>Frames (*.vdb *.csv *.ply *.vtp *.vtu);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Importing %1</source>
        <translation>%1 wird importiert</translation>
    </message>
    <message>
        <source>Another import or export is still running.</source>
        <translation>Ein anderer Import oder Export läuft noch.</translation>
    </message>
    <message>
        <source>Import environment %1</source>
        <translation>Umgebung %1 importieren</translation>
    </message>
    <message>
        <source>%1: cannot be imported; allowed: volumes (.vdb), Gaussians (.csv, .ply, .vtp, .vtu), scenes (.gltf, .glb, .fbx, .obj), meshes (.obj, .ply, .stl, .off), environments (.exr, .hdr), and one scene (.brume) by itself</source>
        <translation>%1: kann nicht importiert werden; erlaubt: Volumen (.vdb), Gaußfunktionen (.csv, .ply, .vtp, .vtu), Szenen (.gltf, .glb, .fbx, .obj), Netze (.obj, .ply, .stl, .off), Umgebungen (.exr, .hdr) und eine einzelne Szene (.brume)</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n Datei</numerusform>
            <numerusform>%n Dateien</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n file(s)</source>
        <translation>
            <numerusform>%n Datei importieren</numerusform>
            <numerusform>%n Dateien importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>The preview of %1 has been changed, so it stays: the fit does not replace it.</source>
        <translation>Die Vorschau von %1 wurde geändert und bleibt daher: Die Anpassung ersetzt sie nicht.</translation>
    </message>
    <message>
        <source>Import sequence %1</source>
        <translation>Sequenz %1 importieren</translation>
    </message>
    <message>
        <source>Refine %1</source>
        <translation>%1 verfeinern</translation>
    </message>
    <message>
        <source>Unknown error</source>
        <translation>Unbekannter Fehler</translation>
    </message>
    <message>
        <source>Radiance transfer</source>
        <translation>Strahlungsübertragung</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The scene's cameras. That in use, in bold, is rendered. A click shows the values of one, Enter uses it, a double click or F2 renames it</source>
        <translation>Die Kameras der Szene. Gerendert wird die verwendete, die fett geschrieben ist. Ein Klick zeigt die Werte einer Kamera, die Eingabetaste verwendet sie, ein Doppelklick oder F2 benennt sie um</translation>
    </message>
    <message>
        <source>Add from View</source>
        <translation>Aus Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Adds a camera that sees what the view sees</source>
        <translation>Fügt eine Kamera hinzu, die sieht, was die Ansicht sieht</translation>
    </message>
    <message>
        <source>Uses it: it is what is rendered</source>
        <translation>Verwendet sie: Gerendert wird, was sie sieht</translation>
    </message>
    <message>
        <source>Look Through</source>
        <translation>Hindurchsehen</translation>
    </message>
    <message>
        <source>Uses it, and shows what it sees (0)</source>
        <translation>Verwendet sie und zeigt, was sie sieht (0)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Deletes the camera</source>
        <translation>Löscht die Kamera</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektivisch</translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation>Orthografisch</translation>
    </message>
    <message>
        <source>Perspective: nearer things look larger, as through a lens. Orthographic: rays are parallel, as on a map or a plan. Both show as much at what the camera looks at</source>
        <translation>Perspektivisch: Näheres sieht größer aus, wie durch ein Objektiv. Orthografisch: Die Strahlen sind parallel, wie auf einer Karte oder einem Plan. Beide zeigen gleich viel von dem, worauf die Kamera blickt</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>36 mm, full frame</source>
        <translation>36 mm, Vollformat</translation>
    </message>
    <message>
        <source>52.48 mm, 65 mm film</source>
        <translation>52,48 mm, 65-mm-Film</translation>
    </message>
    <message>
        <source>43.8 mm, medium format</source>
        <translation>43,8 mm, Mittelformat</translation>
    </message>
    <message>
        <source>24.89 mm, Super 35</source>
        <translation>24,89 mm, Super 35</translation>
    </message>
    <message>
        <source>23.6 mm, APS-C</source>
        <translation>23,6 mm, APS-C</translation>
    </message>
    <message>
        <source>17.3 mm, Four Thirds</source>
        <translation>17,3 mm, Four Thirds</translation>
    </message>
    <message>
        <source>13.2 mm, 1 inch</source>
        <translation>13,2 mm, 1 Zoll</translation>
    </message>
    <message>
        <source>12.52 mm, Super 16</source>
        <translation>12,52 mm, Super 16</translation>
    </message>
    <message>
        <source>Width of the sensor or film that focal lengths are before. The picture stays; it is a setting of yours, not of the scene</source>
        <translation>Breite des Sensors oder Films, vor dem die Brennweiten gelten. Das Bild bleibt; es ist Ihre Einstellung, nicht die der Szene</translation>
    </message>
    <message>
        <source>Film back</source>
        <translation>Filmformat</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>Brennweite</translation>
    </message>
    <message>
        <source>18 mm, very wide</source>
        <translation>18 mm, sehr weit</translation>
    </message>
    <message>
        <source>24 mm, wide</source>
        <translation>24 mm, weit</translation>
    </message>
    <message>
        <source>35 mm, reportage</source>
        <translation>35 mm, Reportage</translation>
    </message>
    <message>
        <source>50 mm, normal</source>
        <translation>50 mm, normal</translation>
    </message>
    <message>
        <source>85 mm, portrait</source>
        <translation>85 mm, Porträt</translation>
    </message>
    <message>
        <source>135 mm, far</source>
        <translation>135 mm, fern</translation>
    </message>
    <message>
        <source>Usual lenses, with names for a sensor 36 mm wide: sets the focal length</source>
        <translation>Übliche Objektive, benannt für einen 36 mm breiten Sensor: setzt die Brennweite</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Anderes</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Focal length, mm</source>
        <translation>Brennweite, mm</translation>
    </message>
    <message>
        <source>Of a lens before the film back: of 36 mm, 24 is wide, 50 normal, 85 and more make things seem closer. The same as the field of view</source>
        <translation>Eines Objektivs vor dem Filmformat: Bei 36 mm ist 24 weit, 50 normal, und ab 85 scheint alles näher. Dasselbe wie das Blickfeld</translation>
    </message>
    <message>
        <source>Focus on what it looks at</source>
        <translation>Auf den Blickpunkt scharf stellen</translation>
    </message>
    <message>
        <source>focus distance</source>
        <translation>Schärfeentfernung</translation>
    </message>
    <message>
        <source>Start, s</source>
        <translation>Beginn, s</translation>
    </message>
    <message>
        <source>Set start of %1</source>
        <translation>Beginn von %1 setzen</translation>
    </message>
    <message>
        <source>When it begins to emit; its rate is 0 before, by keyframes</source>
        <translation>Wann er zu emittieren beginnt; vorher ist seine Rate durch Keyframes 0</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Endet</translation>
    </message>
    <message>
        <source>Set end of %1</source>
        <translation>Ende von %1 setzen</translation>
    </message>
    <message>
        <source>Remove end of %1</source>
        <translation>Ende von %1 entfernen</translation>
    </message>
    <message>
        <source>End, s</source>
        <translation>Ende, s</translation>
    </message>
    <message>
        <source>When it emits no more; its particles live on</source>
        <translation>Wann er nicht mehr emittiert; seine Partikel leben weiter</translation>
    </message>
    <message>
        <source>The rate is 0, or has keyframes of its own: edit them in the dope sheet</source>
        <translation>Die Rate ist 0 oder hat eigene Keyframes: Bearbeiten Sie sie im Dope Sheet</translation>
    </message>
    <message>
        <source>Set %1 of %2</source>
        <translation>%1 von %2 setzen</translation>
    </message>
    <message>
        <source>Emission at birth</source>
        <translation>Emission bei Geburt</translation>
    </message>
    <message>
        <source>at death</source>
        <translation>bei Tod</translation>
    </message>
    <message>
        <source>Set emission of %1</source>
        <translation>Emission von %1 setzen</translation>
    </message>
    <message>
        <source>Set %1 of environment</source>
        <translation>%1 der Umgebung setzen</translation>
    </message>
    <message>
        <source>Set %1 of sky</source>
        <translation>%1 des Himmels setzen</translation>
    </message>
    <message>
        <source>A clear sky with its sun, which can be dragged in the view</source>
        <translation>Ein klarer Himmel mit seiner Sonne, die in der Ansicht gezogen werden kann</translation>
    </message>
    <message>
        <source>The environment as rotated: −z in the centre, +x to the right</source>
        <translation>Die Umgebung, wie sie gedreht ist: −z in der Mitte, +x rechts</translation>
    </message>
    <message>
        <source>Remove environment</source>
        <translation>Umgebung entfernen</translation>
    </message>
    <message>
        <source>Choose an Environment</source>
        <translation>Umgebung wählen</translation>
    </message>
    <message>
        <source>Radiance maps (*.exr *.hdr);;All files (*)</source>
        <translation>Umgebungsbilder (*.exr *.hdr);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>Set environment</source>
        <translation>Umgebung setzen</translation>
    </message>
    <message>
        <source>The active group: brushes, Add Gaussian and Paste add to it</source>
        <translation>Die aktive Gruppe: Pinsel, Gaußfunktion hinzufügen und Einfügen fügen ihr hinzu</translation>
    </message>
    <message>
        <source>Groups keep Gaussians together: select some and press Ctrl+G. What you set here acts on all of a group and leaves their own values as they are.</source>
        <translation>Gruppen halten Gaußfunktionen zusammen: Wählen Sie einige aus und drücken Sie Strg+G. Was Sie hier setzen, wirkt auf die ganze Gruppe und lässt die eigenen Werte, wie sie sind.</translation>
    </message>
    <message>
        <source>Set colour of %1</source>
        <translation>Farbe von %1 setzen</translation>
    </message>
    <message>
        <source>Delete the keyframe at this time (I or K over the field)</source>
        <translation>Keyframe zu dieser Zeit löschen (I oder K über dem Feld)</translation>
    </message>
    <message>
        <source>Set a keyframe at this time (I or K over the field)</source>
        <translation>Keyframe zu dieser Zeit setzen (I oder K über dem Feld)</translation>
    </message>
    <message>
        <source>Delete Keyframe</source>
        <translation>Keyframe löschen</translation>
    </message>
    <message>
        <source>Insert Keyframe</source>
        <translation>Keyframe einfügen</translation>
    </message>
    <message>
        <source>Previous Keyframe</source>
        <translation>Voriger Keyframe</translation>
    </message>
    <message>
        <source>Next Keyframe</source>
        <translation>Nächster Keyframe</translation>
    </message>
    <message>
        <source>Show Curve</source>
        <translation>Kurve zeigen</translation>
    </message>
    <message>
        <source>Add light</source>
        <translation>Licht hinzufügen</translation>
    </message>
    <message>
        <source>Add spot</source>
        <translation>Spot hinzufügen</translation>
    </message>
    <message>
        <source>Adds a light that shines in a cone, at what the view looks at</source>
        <translation>Fügt ein Licht hinzu, das in einem Kegel auf den Blickpunkt der Ansicht scheint</translation>
    </message>
    <message>
        <source>Adds a directional light: its rays are parallel</source>
        <translation>Fügt ein gerichtetes Licht hinzu: Seine Strahlen sind parallel</translation>
    </message>
    <message>
        <source>Add area</source>
        <translation>Fläche hinzufügen</translation>
    </message>
    <message>
        <source>Adds a light that is a surface: its shadows are soft</source>
        <translation>Fügt ein Licht hinzu, das eine Fläche ist: Seine Schatten sind weich</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Adds a light with the colour and shape of one in the world</source>
        <translation>Fügt ein Licht mit Farbe und Form eines wirklichen hinzu</translation>
    </message>
    <message>
        <source>Turn %1 on</source>
        <translation>%1 einschalten</translation>
    </message>
    <message>
        <source>Turn %1 off</source>
        <translation>%1 ausschalten</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>Set intensity of %1</source>
        <translation>Intensität von %1 setzen</translation>
    </message>
    <message>
        <source>Remove %1 of %2</source>
        <translation>%1 von %2 entfernen</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Spreads the light as a luminaire does, measured in an IES file</source>
        <translation>Verteilt das Licht wie eine Leuchte, gemessen in einer IES-Datei</translation>
    </message>
    <message>
        <source>Choose a Photometric Profile</source>
        <translation>Photometrisches Profil wählen</translation>
    </message>
    <message>
        <source>Photometric profiles (*.ies);;All files (*)</source>
        <translation>Photometrische Profile (*.ies);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>A picture in the beam of a spot, a gobo</source>
        <translation>Ein Bild im Kegel eines Spots, ein Gobo</translation>
    </message>
    <message>
        <source>Choose a Picture</source>
        <translation>Bild wählen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg);;All files (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Set profile of %1</source>
        <translation>Profil von %1 setzen</translation>
    </message>
    <message>
        <source>Set texture of %1</source>
        <translation>Textur von %1 setzen</translation>
    </message>
    <message>
        <source>Intensity, cd</source>
        <translation>Intensität, cd</translation>
    </message>
    <message>
        <source>Illuminance, lx</source>
        <translation>Beleuchtungsstärke, lx</translation>
    </message>
    <message>
        <source>Luminance, cd/u²</source>
        <translation>Leuchtdichte, cd/u²</translation>
    </message>
    <message>
        <source>The same in photometric units: 1 W of white light is 683 lm</source>
        <translation>Dasselbe in photometrischen Einheiten: 1 W weißes Licht sind 683 lm</translation>
    </message>
    <message>
        <source>Luminous flux, lm</source>
        <translation>Lichtstrom, lm</translation>
    </message>
    <message>
        <source>Light in all directions together</source>
        <translation>Das Licht in alle Richtungen zusammen</translation>
    </message>
    <message>
        <source>Temperature, K</source>
        <translation>Temperatur, K</translation>
    </message>
    <message>
        <source>Set temperature of %1</source>
        <translation>Temperatur von %1 setzen</translation>
    </message>
    <message>
        <source>Makes the colour that of a black body: a candle 1850 K, a light bulb 2700 K, the sun 5500 K, a blue sky 10000 K</source>
        <translation>Macht die Farbe zu der eines schwarzen Körpers: eine Kerze 1850 K, eine Glühlampe 2700 K, die Sonne 5500 K, ein blauer Himmel 10000 K</translation>
    </message>
    <message>
        <source>What the light comes from</source>
        <translation>Woher das Licht kommt</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Change type of %1</source>
        <translation>Art von %1 ändern</translation>
    </message>
    <message>
        <source>The surface that is shown here</source>
        <translation>Die Oberfläche, die hier gezeigt wird</translation>
    </message>
    <message>
        <source>How the surface reflects light</source>
        <translation>Wie die Oberfläche Licht reflektiert</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Diffus</translation>
    </message>
    <message>
        <source>Phong</source>
        <translation>Phong</translation>
    </message>
    <message>
        <source>Measured…</source>
        <translation>Gemessen …</translation>
    </message>
    <message>
        <source>Metallic-roughness</source>
        <translation>Metallisch-rau</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Shadows and interreflection</source>
        <translation>Schatten und Interreflexion</translation>
    </message>
    <message>
        <source>Precomputed self-shadowing and interreflection within the object, of the environment and of light scattered by fog</source>
        <translation>Vorausberechnete Selbstverschattung und Interreflexion im Objekt, für die Umgebung und vom Nebel gestreutes Licht</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Set radiance transfer of %1</source>
        <translation>Strahlungsübertragung von %1 setzen</translation>
    </message>
    <message>
        <source>The material of the file again</source>
        <translation>Wieder das Material der Datei</translation>
    </message>
    <message>
        <source>Material of file</source>
        <translation>Material der Datei</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Where light is scattered once; all orders shadow and reflect anyway</source>
        <translation>Wo Licht einmal gestreut wird; alle Ordnungen verschatten und reflektieren ohnehin</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Where the origin of the mesh is</source>
        <translation>Wo der Ursprung des Netzes ist</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Euler angles in degrees</source>
        <translation>Eulerwinkel in Grad</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Set size of %1</source>
        <translation>Größe von %1 setzen</translation>
    </message>
    <message>
        <source>Extent of a box, a plane or another simple shape</source>
        <translation>Ausdehnung eines Quaders, einer Ebene oder einer anderen einfachen Form</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 skalieren</translation>
    </message>
    <message>
        <source>Factor of the size of the mesh</source>
        <translation>Faktor der Größe des Netzes</translation>
    </message>
    <message>
        <source>Set holdout of %1</source>
        <translation>Holdout von %1 setzen</translation>
    </message>
    <message>
        <source>More placements of this surface, at random points of another one</source>
        <translation>Mehr Exemplare dieser Oberfläche an zufälligen Stellen einer anderen</translation>
    </message>
    <message>
        <source>Scatter copies of %1</source>
        <translation>Kopien von %1 streuen</translation>
    </message>
    <message>
        <source>Scattered over %1</source>
        <translation>Auf %1 gestreut</translation>
    </message>
    <message>
        <source>Scattered over %1, which is missing</source>
        <translation>Auf %1 gestreut, was fehlt</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopien</translation>
    </message>
    <message>
        <source>Set %1 of the copies of %2</source>
        <translation>%1 der Kopien von %2 setzen</translation>
    </message>
    <message>
        <source>Copies scale, min</source>
        <translation>Kopien Skalierung, min</translation>
    </message>
    <message>
        <source>Copies scale, max</source>
        <translation>Kopien Skalierung, max</translation>
    </message>
    <message>
        <source>Reflectance</source>
        <translation>Reflexionsgrad</translation>
    </message>
    <message>
        <source>Set reflectance of %1</source>
        <translation>Reflexionsgrad von %1 setzen</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>Set specular reflectance of %1</source>
        <translation>Glanz von %1 setzen</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>Set exponent of %1</source>
        <translation>Exponent von %1 setzen</translation>
    </message>
    <message>
        <source>How sharp the highlight is</source>
        <translation>Wie scharf das Glanzlicht ist</translation>
    </message>
    <message>
        <source>Choose a Measured Material</source>
        <translation>Gemessenes Material wählen</translation>
    </message>
    <message>
        <source>MERL materials (*.binary);;All files (*)</source>
        <translation>MERL-Materialien (*.binary);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Set material of %1</source>
        <translation>Material von %1 setzen</translation>
    </message>
    <message>
        <source>Homogeneous density, 1/u</source>
        <translation>Homogene Dichte, 1/u</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Scattering</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Set %1 of noise</source>
        <translation>%1 des Rauschens setzen</translation>
    </message>
    <message>
        <source>Homogeneous fog everywhere</source>
        <translation>Homogener Nebel überall</translation>
    </message>
    <message>
        <source>Without an extent: as far as the view; light from far away crosses as much of it as the scene is wide</source>
        <translation>Ohne Ausdehnung: so weit wie die Sicht; Licht von fern durchquert so viel davon, wie die Szene breit ist</translation>
    </message>
    <message>
        <source>Set homogeneous extent</source>
        <translation>Homogene Ausdehnung setzen</translation>
    </message>
    <message>
        <source>Sets albedo and anisotropy to those of a substance</source>
        <translation>Setzt Albedo und Anisotropie auf die eines Stoffes</translation>
    </message>
    <message>
        <source>Set medium to %1</source>
        <translation>Medium auf %1 setzen</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>Einmal</translation>
    </message>
    <message>
        <source>All orders</source>
        <translation>Alle Ordnungen</translation>
    </message>
    <message>
        <source>How often light is scattered in the fog before it reaches the eye. All orders: any number of times, as in nature; dense fog is brighter. Once: faster. For all views and exports; not part of the scene. Paper always scatters once, and paths all orders.</source>
        <translation>Wie oft Licht im Nebel gestreut wird, bevor es das Auge erreicht. Alle Ordnungen: beliebig oft, wie in der Natur; dichter Nebel ist heller. Einmal: schneller. Für alle Ansichten und Exporte; nicht Teil der Szene. Das Verfahren der Veröffentlichung streut immer einmal, Pfade alle Ordnungen.</translation>
    </message>
    <message>
        <source>Water Fog</source>
        <translation>Wassernebel</translation>
    </message>
    <message>
        <source>Steam</source>
        <translation>Dampf</translation>
    </message>
    <message>
        <source>Dust</source>
        <translation>Staub</translation>
    </message>
    <message>
        <source>Black Smoke</source>
        <translation>Schwarzer Rauch</translation>
    </message>
    <message>
        <source>Base colour texture</source>
        <translation>Textur der Grundfarbe</translation>
    </message>
    <message>
        <source>Roughness texture</source>
        <translation>Textur der Rauheit</translation>
    </message>
    <message>
        <source>Normal map</source>
        <translation>Normal Map</translation>
    </message>
    <message>
        <source>Emissive texture</source>
        <translation>Textur der Emission</translation>
    </message>
    <message>
        <source>Transmission texture</source>
        <translation>Textur der Transmission</translation>
    </message>
    <message>
        <source>Base colour</source>
        <translation>Grundfarbe</translation>
    </message>
    <message>
        <source>Set base colour of %1</source>
        <translation>Grundfarbe von %1 setzen</translation>
    </message>
    <message>
        <source>Opaque</source>
        <translation>Deckend</translation>
    </message>
    <message>
        <source>Cutout</source>
        <translation>Ausgestanzt</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überblendet</translation>
    </message>
    <message>
        <source>Whether opacity makes holes in the surface, or covers a share of it</source>
        <translation>Ob die Deckkraft Löcher in die Oberfläche macht oder einen Anteil davon bedeckt</translation>
    </message>
    <message>
        <source>Set alpha of %1</source>
        <translation>Alpha von %1 setzen</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Remove the texture</source>
        <translation>Textur entfernen</translation>
    </message>
    <message>
        <source>Remove texture of %1</source>
        <translation>Textur von %1 entfernen</translation>
    </message>
    <message>
        <source>PNG or JPEG; of colours also OpenEXR or HDR</source>
        <translation>PNG oder JPEG; für Farben auch OpenEXR oder HDR</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.tga *.bmp *.exr *.hdr);;All files (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.tga *.bmp *.exr *.hdr);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.tga *.bmp);;All files (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.tga *.bmp);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a Texture</source>
        <translation>Textur wählen</translation>
    </message>
    <message>
        <source>PNG picture</source>
        <translation>PNG-Bild</translation>
    </message>
    <message>
        <source>EXR with layers</source>
        <translation>EXR mit Layern</translation>
    </message>
    <message>
        <source>Deep EXR, for holdouts</source>
        <translation>Deep EXR für Holdouts</translation>
    </message>
    <message>
        <source>MP4 video</source>
        <translation>MP4-Video</translation>
    </message>
    <message>
        <source>PNG: ready to show. EXR: linear light in 32-bit floats, with layers, for compositing. MP4: a video of all frames, by the program ffmpeg</source>
        <translation>PNG: fertig zum Zeigen. EXR: lineares Licht in 32-Bit-Gleitkommazahlen, mit Layern, für das Compositing. MP4: ein Video aller Frames, durch das Programm ffmpeg</translation>
    </message>
    <message>
        <source>Videos need the program ffmpeg on the PATH.</source>
        <translation>Videos brauchen das Programm ffmpeg im PATH.</translation>
    </message>
    <message>
        <source>Of each value of a PNG: 16 are for further editing. A setting of yours, not of the scene</source>
        <translation>Jedes Wertes eines PNG: 16 sind zur weiteren Bearbeitung. Ihre Einstellung, nicht die der Szene</translation>
    </message>
    <message>
        <source>8, dithered</source>
        <translation>8, gedithert</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bits</translation>
    </message>
    <message>
        <source>none: into the picture viewer only</source>
        <translation>keine: nur in den Bildbetrachter</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Where pictures are written; frames of an animation get numbers. Without a file, they are only shown</source>
        <translation>Wohin Bilder geschrieben werden; Frames einer Animation erhalten Nummern. Ohne Datei werden sie nur gezeigt</translation>
    </message>
    <message>
        <source>Animation: %1 to %2</source>
        <translation>Animation: %1 bis %2</translation>
    </message>
    <message>
        <source>Pictures are written as .png or .exr, videos as .mp4.</source>
        <translation>Bilder werden als .png oder .exr geschrieben, Videos als .mp4.</translation>
    </message>
    <message>
        <source>Set file of output</source>
        <translation>Ausgabedatei setzen</translation>
    </message>
    <message>
        <source>Output File</source>
        <translation>Ausgabedatei</translation>
    </message>
    <message>
        <source>Pictures and videos (*.png *.exr *.mp4);;All files (*)</source>
        <translation>Bilder und Videos (*.png *.exr *.mp4);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Seen from the view</source>
        <translation>Aus der Ansicht gesehen</translation>
    </message>
    <message>
        <source>Renders what the view sees, not the scene's camera. It is not saved with the scene</source>
        <translation>Rendert, was die Ansicht sieht, nicht die Kamera der Szene. Es wird nicht mit der Szene gespeichert</translation>
    </message>
    <message>
        <source>Usual sizes of pictures, in pixels</source>
        <translation>Übliche Bildgrößen in Pixeln</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Width, px</source>
        <translation>Breite, px</translation>
    </message>
    <message>
        <source>Height, px</source>
        <translation>Höhe, px</translation>
    </message>
    <message>
        <source>Of the rendered picture, in pixels</source>
        <translation>Des gerenderten Bildes in Pixeln</translation>
    </message>
    <message>
        <source>Lock aspect ratio</source>
        <translation>Seitenverhältnis sperren</translation>
    </message>
    <message>
        <source>Width and height change together</source>
        <translation>Breite und Höhe ändern sich zusammen</translation>
    </message>
    <message>
        <source>Whole Picture</source>
        <translation>Ganzes Bild</translation>
    </message>
    <message>
        <source>Renders the whole picture again, not only the region</source>
        <translation>Rendert wieder das ganze Bild, nicht nur den Ausschnitt</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Set method of rendering</source>
        <translation>Renderverfahren setzen</translation>
    </message>
    <message>
        <source>Paths per pixel</source>
        <translation>Pfade pro Pixel</translation>
    </message>
    <message>
        <source>Set paths per pixel</source>
        <translation>Pfade pro Pixel setzen</translation>
    </message>
    <message>
        <source>Samples of each pixel: four times as many halve the noise and take four times as long</source>
        <translation>Stichproben jedes Pixels: Viermal so viele halbieren das Rauschen und dauern viermal so lange</translation>
    </message>
    <message>
        <source>Of the animation; the same as in the timeline</source>
        <translation>Der Animation; dieselben wie in der Zeitleiste</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Frames pro Sekunde</translation>
    </message>
    <message>
        <source>Of the timeline and of videos. Keyframes keep their times in seconds</source>
        <translation>Der Zeitleiste und von Videos. Keyframes behalten ihre Zeiten in Sekunden</translation>
    </message>
    <message>
        <source>Set playback range</source>
        <translation>Abspielbereich setzen</translation>
    </message>
    <message>
        <source>Set layers of output</source>
        <translation>Layer der Ausgabe setzen</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Layer</translation>
    </message>
    <message>
        <source>Only flat EXR files have layers</source>
        <translation>Nur flache EXR-Dateien haben Layer</translation>
    </message>
    <message>
        <source>Exposure as in the view</source>
        <translation>Belichtung wie in der Ansicht</translation>
    </message>
    <message>
        <source>Pictures are as bright as the view (+ and -). EXR files are never changed</source>
        <translation>Bilder sind so hell wie die Ansicht (+ und -). EXR-Dateien werden nie geändert</translation>
    </message>
    <message>
        <source>Set exposure of output</source>
        <translation>Belichtung der Ausgabe setzen</translation>
    </message>
    <message>
        <source>One stop more is twice as bright. Of PNG and MP4; shown by Khronos PBR Neutral in sRGB</source>
        <translation>Eine Blendenstufe mehr ist doppelt so hell. Für PNG und MP4; gezeigt mit Khronos PBR Neutral in sRGB</translation>
    </message>
    <message>
        <source>Full HD, 1920 × 1080</source>
        <translation>Full HD, 1920 × 1080</translation>
    </message>
    <message>
        <source>4K UHD, 3840 × 2160</source>
        <translation>4K UHD, 3840 × 2160</translation>
    </message>
    <message>
        <source>Cinema 2K, 2048 × 858</source>
        <translation>Kino 2K, 2048 × 858</translation>
    </message>
    <message>
        <source>Square, 1080 × 1080</source>
        <translation>Quadrat, 1080 × 1080</translation>
    </message>
    <message>
        <source>Upright, 1080 × 1920</source>
        <translation>Hochformat, 1080 × 1920</translation>
    </message>
    <message>
        <source>Choose samples</source>
        <translation>Abtastung selbst wählen</translation>
    </message>
    <message>
        <source>As many samples of a pixel as it needs: %1 at the edges of surfaces, %2 of all pixels where the lens or the shutter blurs</source>
        <translation>So viele Abtastwerte eines Pixels, wie er braucht: %1 an Kanten von Oberflächen, %2 aller Pixel, wo Objektiv oder Verschluss unscharf machen</translation>
    </message>
    <message>
        <source>Set samples of output</source>
        <translation>Abtastwerte der Ausgabe setzen</translation>
    </message>
    <message>
        <source>Samples per pixel</source>
        <translation>Abtastwerte pro Pixel</translation>
    </message>
    <message>
        <source>Of pixels at edges, filtered; 1 takes the centres of all pixels. Where the lens or the shutter blurs, as many whole frames are rendered</source>
        <translation>Von Pixeln an Kanten, gefiltert; 1 nimmt die Mitten aller Pixel. Wo Objektiv oder Verschluss unscharf machen, werden so viele ganze Bilder gerendert</translation>
    </message>
    <message>
        <source>Motion blur</source>
        <translation>Bewegungsunschärfe</translation>
    </message>
    <message>
        <source>What moves while the shutter is open is blurred: camera, lights and fog. Every sample takes a whole frame</source>
        <translation>Was sich bewegt, während der Verschluss offen ist, wird unscharf: Kamera, Lichter und Nebel. Jeder Abtastwert braucht ein ganzes Bild</translation>
    </message>
    <message>
        <source>Set motion blur</source>
        <translation>Bewegungsunschärfe setzen</translation>
    </message>
    <message>
        <source>The shutter closes after it opens.</source>
        <translation>Der Verschluss schließt, nachdem er öffnet.</translation>
    </message>
    <message>
        <source>Shutter opens, frames</source>
        <translation>Verschluss öffnet, Frames</translation>
    </message>
    <message>
        <source>After the time of the frame; negative before it</source>
        <translation>Nach der Zeit des Frames; negativ davor</translation>
    </message>
    <message>
        <source>Shutter closes, frames</source>
        <translation>Verschluss schließt, Frames</translation>
    </message>
    <message>
        <source>After the time of the frame. Half a frame after it opens is usual for film</source>
        <translation>Nach der Zeit des Frames. Ein halber Frame nach dem Öffnen ist beim Film üblich</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Removes the plate</source>
        <translation>Entfernt das Foto</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Hintergrundfoto</translation>
    </message>
    <message>
        <source>Plate opacity</source>
        <translation>Deckkraft des Fotos</translation>
    </message>
    <message>
        <source>0 shows the scene alone, 1 the plate alone</source>
        <translation>0 zeigt nur die Szene, 1 nur das Foto</translation>
    </message>
    <message>
        <source>Plate of each frame</source>
        <translation>Hintergrundfoto je Bild</translation>
    </message>
    <message>
        <source>The picture is one of several, whose names differ in the number of the frame: shows the last one up to the current frame</source>
        <translation>Das Foto ist eines von mehreren, deren Namen sich in der Bildnummer unterscheiden: zeigt das letzte bis zum aktuellen Bild</translation>
    </message>
    <message>
        <source>Behind the fog</source>
        <translation>Hinter dem Nebel</translation>
    </message>
    <message>
        <source>The plate is seen through the fog, in place of the environment, and where surfaces are held out (panel Surface)</source>
        <translation>Das Foto ist durch den Nebel zu sehen, an Stelle der Umgebung und dort, wo Oberflächen Holdouts sind (Bedienfeld Oberfläche)</translation>
    </message>
    <message>
        <source>A photographed picture over the frame of the camera, or behind its fog, to match the scene with. It is not rendered, and not saved with the scene</source>
        <translation>Ein Foto über dem Bild der Kamera oder hinter dessen Nebel, um die Szene daran anzupassen. Es wird nicht gerendert und nicht mit der Szene gespeichert</translation>
    </message>
    <message>
        <source>Unit: %1</source>
        <translation>Einheit: %1</translation>
    </message>
    <message>
        <source>%1 at birth</source>
        <translation>%1 bei Geburt</translation>
    </message>
    <message>
        <source>Filter: radius &lt; 0.5, density &gt; 0.2</source>
        <translation>Filter: radius &lt; 0.5, density &gt; 0.2</translation>
    </message>
    <message>
        <source>Select Shown</source>
        <translation>Gezeigte auswählen</translation>
    </message>
    <message>
        <source>Select all rows of the table (Enter)</source>
        <translation>Alle Zeilen der Tabelle auswählen (Eingabetaste)</translation>
    </message>
    <message>
        <source>Save as Group</source>
        <translation>Als Gruppe sichern</translation>
    </message>
    <message>
        <source>Make a group of all rows of the table, named as they are asked for</source>
        <translation>Macht eine Gruppe aus allen Zeilen der Tabelle, benannt nach der Abfrage</translation>
    </message>
    <message>
        <source>Filter the table by %1 or group</source>
        <translation>Tabelle filtern nach %1 oder group</translation>
    </message>
    <message>
        <source>x, y, z, radius, density, albedo, emission, radius x to z, rotation x to z, elongation, id</source>
        <translation>x, y, z, radius, density, albedo, emission, radius x bis z, rotation x bis z, elongation, id</translation>
    </message>
    <message>
        <source>“%1” lacks a comparison: &lt;, &lt;=, &gt;, &gt;= or =, as in density &gt; 0.2.</source>
        <translation>„%1“ fehlt ein Vergleich: &lt;, &lt;=, &gt;, &gt;= oder =, wie in density &gt; 0.2.</translation>
    </message>
    <message>
        <source>“%1” is no attribute; allowed are %2 and group.</source>
        <translation>„%1“ ist kein Attribut; erlaubt sind %2 und group.</translation>
    </message>
    <message>
        <source>A group is compared by =, as in group = steam.</source>
        <translation>Eine Gruppe wird mit = verglichen, wie in group = steam.</translation>
    </message>
    <message>
        <source>“%1” lacks what it is compared with.</source>
        <translation>„%1“ fehlt, womit verglichen wird.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Zentrum</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>Radien</translation>
    </message>
    <message>
        <source>The place of its largest density</source>
        <translation>Der Ort der größten Dichte</translation>
    </message>
    <message>
        <source>At this distance its density is 1/e of the largest</source>
        <translation>In diesem Abstand ist die Dichte 1/e der größten</translation>
    </message>
    <message>
        <source>The scattering coefficient at its centre, per unit of length</source>
        <translation>Der Streukoeffizient im Zentrum pro Längeneinheit</translation>
    </message>
    <message>
        <source>Euler angles in degrees that turn an ellipsoid's axes</source>
        <translation>Eulerwinkel in Grad, die die Achsen eines Ellipsoids drehen</translation>
    </message>
    <message>
        <source>Along its own axes: equal ones make it a ball</source>
        <translation>Entlang der eigenen Achsen: Gleiche machen es zur Kugel</translation>
    </message>
    <message>
        <source>Drag to select the Gaussians in a range; Shift adds, Ctrl removes</source>
        <translation>Ziehen wählt die Gaußfunktionen eines Bereichs aus; Umschalt fügt hinzu, Strg nimmt weg</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>All of these are hidden or locked.</source>
        <translation>Alle davon sind ausgeblendet oder gesperrt.</translation>
    </message>
    <message>
        <source>A scene has at most %L1 groups.</source>
        <translation>Eine Szene hat höchstens %L1 Gruppen.</translation>
    </message>
    <message>
        <source>Save %1 as group</source>
        <translation>%1 als Gruppe sichern</translation>
    </message>
    <message>
        <source>The medium's albedo: %1</source>
        <translation>Die Albedo des Mediums: %1</translation>
    </message>
    <message>
        <source>A number, or a colour: 0.9 0.2 0.1, #e6331a or 2700 K</source>
        <translation>Eine Zahl oder eine Farbe: 0.9 0.2 0.1, #e6331a oder 2700 K</translation>
    </message>
    <message>
        <source>%1 is in use: it is rendered</source>
        <translation>%1 wird verwendet: Sie wird gerendert</translation>
    </message>
    <message>
        <source>%1: its icon uses it</source>
        <translation>%1: Ihr Symbol verwendet sie</translation>
    </message>
    <message>
        <source>Use and look through</source>
        <translation>Verwenden und hindurchsehen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Gaussians that are in no group. Brushes paint there while no group is active; a click makes it so.</source>
        <translation>Gaußfunktionen in keiner Gruppe. Pinsel malen dort, solange keine Gruppe aktiv ist; ein Klick macht es so.</translation>
    </message>
    <message>
        <source>%1: a click selects its Gaussians, and brushes paint into it. Double click or F2 renames it.</source>
        <translation>%1: Ein Klick wählt ihre Gaußfunktionen aus, und Pinsel malen in sie. Doppelklick oder F2 benennt sie um.</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Lock: its Gaussians can be neither selected nor erased</source>
        <translation>Sperren: Ihre Gaußfunktionen können weder ausgewählt noch radiert werden</translation>
    </message>
    <message>
        <source>In no group</source>
        <translation>In keiner Gruppe</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Move Selection Here</source>
        <translation>Auswahl hierher verschieben</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Move into</source>
        <translation>Verschieben in</translation>
    </message>
    <message>
        <source>Move out of Group</source>
        <translation>Aus der Gruppe herausnehmen</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Gruppierung aufheben</translation>
    </message>
    <message>
        <source>Delete with Gaussians</source>
        <translation>Mit Gaußfunktionen löschen</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Medium</translation>
    </message>
    <message>
        <source>Drag it onto a group to move the selected Gaussians there</source>
        <translation>Auf eine Gruppe ziehen, um die ausgewählten Gaußfunktionen dorthin zu verschieben</translation>
    </message>
    <message>
        <source>Sequence %1, frames %2 to %3</source>
        <translation>Sequenz %1, Frames %2 bis %3</translation>
    </message>
    <message>
        <source>Environment: %1</source>
        <translation>Umgebung: %1</translation>
    </message>
    <message>
        <source>Lock: the view leaves it alone</source>
        <translation>Sperren: Die Ansicht lässt es in Ruhe</translation>
    </message>
    <message numerus="yes">
        <source>%1 Gaussian(s)</source>
        <translation>
            <numerusform>%1 Gaußfunktion</numerusform>
            <numerusform>%1 Gaußfunktionen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: a click shows its points, to bend the line and paint its fog again.</source>
        <translation>%1: Ein Klick zeigt die Punkte, um die Linie zu biegen und den Nebel neu zu malen.</translation>
    </message>
    <message>
        <source>Edit Points</source>
        <translation>Punkte bearbeiten</translation>
    </message>
    <message>
        <source>Select Its Gaussians</source>
        <translation>Gaußfunktionen auswählen</translation>
    </message>
    <message>
        <source>Delete with Fog</source>
        <translation>Mit Nebel löschen</translation>
    </message>
    <message>
        <source>Delete, Keep Fog</source>
        <translation>Löschen, Nebel behalten</translation>
    </message>
    <message>
        <source>Gaussian %1</source>
        <translation>Gaußfunktion %1</translation>
    </message>
    <message>
        <source>Point at fog to see what each Gaussian contributes to the pixel.</source>
        <translation>Zeigen Sie auf Nebel, um zu sehen, was jede Gaußfunktion zum Pixel beiträgt.</translation>
    </message>
    <message>
        <source>%1, selected</source>
        <translation>%1, ausgewählt</translation>
    </message>
    <message>
        <source>Attenuates</source>
        <translation>Schwächt ab</translation>
    </message>
    <message numerus="yes">
        <source>%n Gaussian(s) on this ray</source>
        <translation>
            <numerusform>%n Gaußfunktion auf diesem Strahl</numerusform>
            <numerusform>%n Gaußfunktionen auf diesem Strahl</numerusform>
        </translation>
    </message>
    <message>
        <source>
On screen</source>
        <translation>
Auf dem Bildschirm</translation>
    </message>
    <message>
        <source>
Auto's choice</source>
        <translation>
Wahl von Auto</translation>
    </message>
    <message>
        <source>Settings tried in this scene: error against milliseconds per frame. Filled point: on screen; ring: auto's choice; line: error bound.</source>
        <translation>In dieser Szene versuchte Einstellungen: Fehler gegen Millisekunden pro Bild. Gefüllter Punkt: auf dem Bildschirm; Ring: Wahl von Auto; Linie: Fehlergrenze.</translation>
    </message>
    <message>
        <source>multiple scattering</source>
        <translation>Mehrfachstreuung</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Paper's method</source>
        <translation>Verfahren der Veröffentlichung</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>More paths while nothing changes.</source>
        <translation>Mehr Pfade, solange sich nichts ändert.</translation>
    </message>
    <message>
        <source>Chosen in the View menu.</source>
        <translation>Im Menü Ansicht gewählt.</translation>
    </message>
    <message>
        <source>Not measured yet in this scene.</source>
        <translation>In dieser Szene noch nicht gemessen.</translation>
    </message>
    <message>
        <source>The error may exceed %1, even with finer settings.</source>
        <translation>Der Fehler kann %1 übersteigen, auch mit feineren Einstellungen.</translation>
    </message>
    <message>
        <source>Finest setting; it cannot meet %1.</source>
        <translation>Feinste Einstellung; sie erreicht %1 nicht.</translation>
    </message>
    <message>
        <source>Cheapest setting; it meets %1.</source>
        <translation>Günstigste Einstellung; sie hält %1 ein.</translation>
    </message>
    <message>
        <source>Meets %1. The error of %2 was up to %3.</source>
        <translation>Hält %1 ein. Der Fehler von %2 war bis zu %3.</translation>
    </message>
    <message>
        <source>Meets %1, but not by enough to try %2.</source>
        <translation>Hält %1 ein, aber nicht deutlich genug, um %2 zu versuchen.</translation>
    </message>
    <message>
        <source>%1 of %2 used</source>
        <translation>%1 von %2 verwendet</translation>
    </message>
    <message>
        <source>%1 of %2 used, merged from %3</source>
        <translation>%1 von %2 verwendet, zusammengefasst aus %3</translation>
    </message>
    <message>
        <source>The error that auto keeps below</source>
        <translation>Der Fehler, unter dem Auto bleibt</translation>
    </message>
    <message>
        <source>Max error</source>
        <translation>Max. Fehler</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>How long the picture took to render, in milliseconds or seconds</source>
        <translation>Wie lange das Rendern des Bildes gedauert hat, in Millisekunden oder Sekunden</translation>
    </message>
    <message>
        <source>Relative RMSE of the airlight against the reference, and of the whole picture beside all the light there is; of a path-traced picture its noise. Grey while it is being measured</source>
        <translation>Relativer RMSE des Luftlichts gegen die Referenz und des ganzen Bildes neben allem Licht, das es gibt; bei Path Tracing das Rauschen. Grau, während er gemessen wird</translation>
    </message>
    <message>
        <source>Chosen in View &gt; Quality; the more slices along a ray, the more exact</source>
        <translation>Gewählt unter Ansicht &gt; Qualität; je mehr Scheiben entlang eines Strahls, desto genauer</translation>
    </message>
    <message>
        <source>How often light is scattered, chosen in the panel Medium. All orders are solved on a grid, by sweeps over it, until a sweep changes hardly anything</source>
        <translation>Wie oft Licht gestreut wird, gewählt im Bedienfeld Medium. Alle Ordnungen werden auf einem Gitter durch Durchläufe gelöst, bis ein Durchlauf kaum noch etwas ändert</translation>
    </message>
    <message>
        <source>Render device</source>
        <translation>Rendergerät</translation>
    </message>
    <message>
        <source>Chosen in View &gt; Render Device</source>
        <translation>Gewählt unter Ansicht &gt; Rendergerät</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervall</translation>
    </message>
    <message>
        <source>Contains the error of all the airlight in 95% of cases</source>
        <translation>Enthält in 95 % der Fälle den Fehler des gesamten Luftlichts</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Median error of blocks of 8 × 8 pixels, each relative to its own airlight, and its interval: what the eye sees in dark parts beside bright ones</source>
        <translation>Median der Fehler von Blöcken aus 8 × 8 Pixeln, jeder relativ zu seinem Luftlicht, und sein Intervall: was das Auge in dunklen Teilen neben hellen sieht</translation>
    </message>
    <message>
        <source>Picture's blocks</source>
        <translation>Blöcke des Bildes</translation>
    </message>
    <message>
        <source>The same of the whole picture: with surfaces, mirrors, panes, what shines and the environment, beside all the light that there is</source>
        <translation>Dasselbe vom ganzen Bild: mit Oberflächen, Spiegeln, Scheiben, Leuchtendem und der Umgebung, neben allem Licht, das es gibt</translation>
    </message>
    <message>
        <source>Those that this view needs, of all</source>
        <translation>Die diese Ansicht braucht, von allen</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>Evaluated pairs of Gaussian and ray, from the eye and from the lights</source>
        <translation>Ausgewertete Paare von Gaußfunktion und Strahl, vom Auge und von den Lichtern</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Width and height in pixels</source>
        <translation>Breite und Höhe in Pixeln</translation>
    </message>
    <message>
        <source>Render stage</source>
        <translation>Renderstufe</translation>
    </message>
    <message>
        <source>Milliseconds</source>
        <translation>Millisekunden</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>The state of auto, the settings tried, and the time of each stage</source>
        <translation>Der Stand von Auto, die versuchten Einstellungen und die Zeit jeder Stufe</translation>
    </message>
    <message>
        <source>%1 (%2 pixels)</source>
        <translation>%1 (%2 Pixel)</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>wird gemessen</translation>
    </message>
    <message>
        <source>%1 eye, %2 lights</source>
        <translation>%1 Auge, %2 Lichter</translation>
    </message>
    <message>
        <source>%1 in motion</source>
        <translation>%1 in Bewegung</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>on the CPU: %1</source>
        <translation>auf der CPU: %1</translation>
    </message>
    <message>
        <source>skipped: %1</source>
        <translation>übersprungen: %1</translation>
    </message>
    <message>
        <source>Drag keys in time and value, and the ends of their tangents (Alt: one side alone). Shift or a rectangle selects several. Del to delete, right-click for options, double-click to add a key. Wheel to zoom (Shift: time only, Ctrl: value only), middle button to pan, Home to fit.</source>
        <translation>Keyframes in Zeit und Wert ziehen, ebenso die Enden ihrer Tangenten (Alt: nur eine Seite). Umschalt oder ein Rechteck wählt mehrere aus. Entf löscht, Rechtsklick zeigt mehr, Doppelklick setzt einen Keyframe. Mausrad zoomt (Umschalt: nur Zeit, Strg: nur Wert), mittlere Taste verschiebt, Pos1 passt ein.</translation>
    </message>
    <message>
        <source>No curve is shown. The diamond beside a value sets its first keyframe; the list at the left shows and hides the curves of values that have some.</source>
        <translation>Keine Kurve wird gezeigt. Die Raute neben einem Wert setzt seinen ersten Keyframe; die Liste links blendet die Kurven von Werten ein und aus, die welche haben.</translation>
    </message>
    <message>
        <source>Values of %1</source>
        <translation>Werte von %1</translation>
    </message>
    <message>
        <source>Align to &amp;Playhead</source>
        <translation>An Zeitmarke ausrichten</translation>
    </message>
    <message>
        <source>Same &amp;Value</source>
        <translation>Gleicher Wert</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Values with keyframes: checked ones are shown, a double click shows one alone</source>
        <translation>Werte mit Keyframes: Angekreuzte werden gezeigt, ein Doppelklick zeigt einen allein</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Show the whole curves (Home)</source>
        <translation>Die ganzen Kurven zeigen (Pos1)</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the curves of all values</source>
        <translation>Die Kurven aller Werte zeigen</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>Allein zeigen</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Dope sheet</source>
        <translation>Dope Sheet</translation>
    </message>
    <message>
        <source>Drag keyframes to other frames; Shift or a rectangle selects several. Del to delete, Ctrl+C and Ctrl+V to copy, right-click for options, double-click to add one. Names are chosen for the curves and for I. Ctrl and the wheel zoom, the middle button pans, Home fits.</source>
        <translation>Keyframes auf andere Frames ziehen; Umschalt oder ein Rechteck wählt mehrere aus. Entf löscht, Strg+C und Strg+V kopieren, Rechtsklick zeigt mehr, Doppelklick setzt einen. Namen werden für die Kurven und für I gewählt. Strg und Mausrad zoomt, mittlere Taste verschiebt, Pos1 passt ein.</translation>
    </message>
    <message>
        <source>Nothing is animated yet. The diamond beside a value sets its first keyframe; so does K with the mouse over it.</source>
        <translation>Noch ist nichts animiert. Die Raute neben einem Wert setzt seinen ersten Keyframe, ebenso K mit der Maus darüber.</translation>
    </message>
    <message>
        <source>No animated value has &quot;%1&quot; in its name.</source>
        <translation>Kein animierter Wert hat „%1“ im Namen.</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Show &amp;Curves</source>
        <translation>Kurven zeigen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>&amp;Constant</source>
        <translation>Konstant</translation>
    </message>
    <message>
        <source>Automatic &amp;Tangents</source>
        <translation>Automatische Tangenten</translation>
    </message>
    <message>
        <source>Ali&amp;gned Tangents</source>
        <translation>Ausgerichtete Tangenten</translation>
    </message>
    <message>
        <source>&amp;Free Tangents</source>
        <translation>Freie Tangenten</translation>
    </message>
    <message>
        <source>%1 of %2 fps</source>
        <translation>%1 von %2 fps</translation>
    </message>
    <message>
        <source>%1, %2 dropped</source>
        <translation>%1, %2 ausgelassen</translation>
    </message>
    <message>
        <source>Frames per second that the view shows, of the scene's rate. Frames that take too long are dropped, so that time runs as it will; once a loop is cached, none are.</source>
        <translation>Frames pro Sekunde, die die Ansicht zeigt, von der Rate der Szene. Frames, die zu lange dauern, werden ausgelassen, damit die Zeit richtig läuft; ist eine Schleife gespeichert, fehlt keiner.</translation>
    </message>
    <message>
        <source>Drag to another frame. Wheel to zoom, middle button to pan, double-click to show the range. The bar below shows which frames are cached: bright at full quality, dim as they were shown during playback.</source>
        <translation>Auf einen anderen Frame ziehen. Mausrad zoomt, mittlere Taste verschiebt, Doppelklick zeigt den Bereich. Der Balken darunter zeigt, welche Frames gespeichert sind: hell in voller Qualität, matt, wie sie beim Abspielen gezeigt wurden.</translation>
    </message>
    <message>
        <source>Go to the first frame</source>
        <translation>Zum ersten Frame</translation>
    </message>
    <message>
        <source>Previous frame (,)</source>
        <translation>Voriger Frame (,)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>Next frame (.)</source>
        <translation>Nächster Frame (.)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>First frame of the range</source>
        <translation>Erster Frame des Bereichs</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Last frame of the range</source>
        <translation>Letzter Frame des Bereichs</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Playback begins again at the end of the range</source>
        <translation>Am Ende des Bereichs beginnt das Abspielen von vorn</translation>
    </message>
    <message>
        <source>Show or hide the curves of the animated values</source>
        <translation>Kurven der animierten Werte ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Shows the values that have this in their names</source>
        <translation>Zeigt die Werte, die dies im Namen haben</translation>
    </message>
    <message>
        <source>Filter of animated values</source>
        <translation>Filter der animierten Werte</translation>
    </message>
    <message>
        <source>Nothing in this slot yet. F12 renders a picture into it; Keep View keeps what the view shows. Then choose two of them as A and B to compare.</source>
        <translation>Noch nichts in diesem Fach. F12 rendert ein Bild hinein; Ansicht behalten behält, was die Ansicht zeigt. Wählen Sie dann zwei als A und B zum Vergleich.</translation>
    </message>
    <message>
        <source>A and B differ in size.</source>
        <translation>A und B sind verschieden groß.</translation>
    </message>
    <message>
        <source>A alone</source>
        <translation>Nur A</translation>
    </message>
    <message>
        <source>Wipe A | B</source>
        <translation>Teilen A | B</translation>
    </message>
    <message>
        <source>Difference A − B</source>
        <translation>Differenz A − B</translation>
    </message>
    <message>
        <source>Wipe: A left and B right of a line; drag the line</source>
        <translation>Teilen: A links und B rechts einer Linie; ziehen Sie die Linie</translation>
    </message>
    <message>
        <source>How many times the difference is shown</source>
        <translation>Wie vielfach die Differenz gezeigt wird</translation>
    </message>
    <message>
        <source>What is shown of the pictures: all their light, or a layer</source>
        <translation>Was von den Bildern gezeigt wird: all ihr Licht oder ein Layer</translation>
    </message>
    <message>
        <source>Shows the whole picture</source>
        <translation>Zeigt das ganze Bild</translation>
    </message>
    <message>
        <source>A pixel of the picture on a pixel of the screen</source>
        <translation>Ein Pixel des Bildes auf einem Pixel des Bildschirms</translation>
    </message>
    <message>
        <source>Clear Slot</source>
        <translation>Fach leeren</translation>
    </message>
    <message>
        <source>Empties the slot that is shown as A</source>
        <translation>Leert das Fach, das als A gezeigt wird</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Saves the picture that is shown as A, as it looks, as a PNG with its note</source>
        <translation>Speichert das als A gezeigte Bild, wie es aussieht, als PNG mit seiner Notiz</translation>
    </message>
    <message>
        <source>Keep View</source>
        <translation>Ansicht behalten</translation>
    </message>
    <message>
        <source>Keeps what the view shows in the next empty slot</source>
        <translation>Behält, was die Ansicht zeigt, im nächsten leeren Fach</translation>
    </message>
    <message>
        <source>How the values of the shown picture are spread: how many pixels have each, black left and white right, or those of each of its columns, black at the bottom</source>
        <translation>Wie sich die Werte des gezeigten Bildes verteilen: wie viele Pixel jeden haben, Schwarz links und Weiß rechts, oder die Werte jeder Spalte, Schwarz unten</translation>
    </message>
    <message>
        <source>No scope</source>
        <translation>Keine Anzeige</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>Waveform</source>
        <translation>Waveform</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>The name of the picture that is shown as A</source>
        <translation>Der Name des als A gezeigten Bildes</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>What there is to say of the picture that is shown as A</source>
        <translation>Was zum als A gezeigten Bild zu sagen ist</translation>
    </message>
    <message>
        <source>Linear radiance of the pixel under the mouse, red, green and blue, or what the layer has there</source>
        <translation>Lineare Strahldichte des Pixels unter der Maus, Rot, Grün und Blau, oder was der Layer dort hat</translation>
    </message>
    <message>
        <source>A differs from B by %1 (relative RMS)</source>
        <translation>A unterscheidet sich von B um %1 (relativer RMS)</translation>
    </message>
    <message>
        <source>Pixel %1, %2</source>
        <translation>Pixel %1, %2</translation>
    </message>
    <message>
        <source>Shows slot %1 as A</source>
        <translation>Zeigt Fach %1 als A</translation>
    </message>
    <message>
        <source>Compares A with slot %1, as B</source>
        <translation>Vergleicht A mit Fach %1 als B</translation>
    </message>
    <message>
        <source>Slot %1, empty</source>
        <translation>Fach %1, leer</translation>
    </message>
    <message>
        <source>Hold to spray fog that bounces off surfaces; release to leave it in place. Inside fills a closed mesh.</source>
        <translation>Halten, um Nebel zu sprühen, der von Oberflächen abprallt; loslassen, um ihn stehen zu lassen. Innen füllt ein geschlossenes Netz.</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>Random variation of radius and density: at 1 from half to double</source>
        <translation>Zufällige Änderung von Radius und Dichte: bei 1 von der Hälfte bis zum Doppelten</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Spray %1</source>
        <translation>%1 sprühen</translation>
    </message>
    <message>
        <source>Soft mist</source>
        <translation>Weicher Nebel</translation>
    </message>
    <message>
        <source>Wisps</source>
        <translation>Schwaden</translation>
    </message>
    <message>
        <source>Cloud puffs</source>
        <translation>Wolkenbällchen</translation>
    </message>
    <message>
        <source>Dense smoke</source>
        <translation>Dichter Rauch</translation>
    </message>
    <message>
        <source>Fine line</source>
        <translation>Feine Linie</translation>
    </message>
    <message>
        <source>Streaks</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Glaze</source>
        <translation>Lasur</translation>
    </message>
    <message>
        <source>Light spray</source>
        <translation>Leichter Sprühnebel</translation>
    </message>
    <message>
        <source>Steam jet</source>
        <translation>Dampfstrahl</translation>
    </message>
    <message>
        <source>Dust burst</source>
        <translation>Staubstoß</translation>
    </message>
    <message>
        <source>Drag to thin the fog; Gaussians of zero density are deleted. [ and ] change the radius, with Shift the strength.</source>
        <translation>Ziehen dünnt den Nebel aus; Gaußfunktionen ohne Dichte werden gelöscht. [ und ] ändern den Radius, mit Umschalt die Stärke.</translation>
    </message>
    <message>
        <source>Radius, px</source>
        <translation>Radius, px</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Erase %1</source>
        <translation>%1 radieren</translation>
    </message>
    <message>
        <source>Albedo and emission of what is added: coloured smoke, fire</source>
        <translation>Albedo und Emission dessen, was hinzukommt: farbiger Rauch, Feuer</translation>
    </message>
    <message>
        <source>Smoothing, px</source>
        <translation>Glättung, px</translation>
    </message>
    <message>
        <source>How far the brush trails behind the mouse, in pixels: steadier lines</source>
        <translation>Wie weit der Pinsel der Maus nachläuft, in Pixeln: ruhigere Linien</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Another number makes other random offsets</source>
        <translation>Eine andere Zahl gibt andere zufällige Versätze</translation>
    </message>
    <message>
        <source>How much longer Gaussians are along their way than across it: 1 lays balls, more as many times fewer ellipsoids</source>
        <translation>Wie viel länger Gaußfunktionen entlang des Wegs sind als quer dazu: 1 legt Kugeln, mehr entsprechend weniger Ellipsoide</translation>
    </message>
    <message>
        <source>Drag to paint fog. [ and ] change the radius, with Shift the density; Alt + click picks both and the colours from the fog.</source>
        <translation>Ziehen malt Nebel. [ und ] ändern den Radius, mit Umschalt die Dichte; Alt + Klick nimmt beide und die Farben aus dem Nebel.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance between Gaussians along the stroke, relative to their radius along it</source>
        <translation>Abstand der Gaußfunktionen entlang des Strichs, relativ zu ihrem Radius in dieser Richtung</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Maximum random offset across the stroke, relative to the radius</source>
        <translation>Größter zufälliger Versatz quer zum Strich, relativ zum Radius</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Fluss</translation>
    </message>
    <message>
        <source>Share of the density that one pass adds: 1 all of it, less builds up</source>
        <translation>Anteil der Dichte, den ein Zug hinzufügt: 1 alles, weniger baut sich auf</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Weicher Rand</translation>
    </message>
    <message>
        <source>How much thinner fog is at the rim of the scatter: 0 as dense, 1 nothing</source>
        <translation>Wie viel dünner der Nebel am Rand der Streuung ist: 0 gleich dicht, 1 nichts</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>%1 malen</translation>
    </message>
    <message>
        <source>Your brushes cannot be read</source>
        <translation>Ihre Pinsel können nicht gelesen werden</translation>
    </message>
    <message>
        <source>Name of this brush</source>
        <translation>Name dieses Pinsels</translation>
    </message>
    <message>
        <source>Keeps this brush among your own; its size follows the view</source>
        <translation>Behält diesen Pinsel unter Ihren eigenen; seine Größe folgt der Ansicht</translation>
    </message>
    <message>
        <source>Ready-made brushes and your own; sizes follow the view</source>
        <translation>Fertige Pinsel und Ihre eigenen; die Größen folgen der Ansicht</translation>
    </message>
    <message>
        <source>Repaint spline</source>
        <translation>Spline neu malen</translation>
    </message>
    <message>
        <source>Click to add points, drag them to bend the line, Ctrl + click removes one. The brush can be changed until New begins another.</source>
        <translation>Ein Klick fügt Punkte hinzu, Ziehen biegt die Linie, Strg + Klick entfernt einen. Der Pinsel kann geändert werden, bis Neu eine andere beginnt.</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Leaves this line as it is; the next click begins another</source>
        <translation>Lässt diese Linie, wie sie ist; der nächste Klick beginnt eine andere</translation>
    </message>
    <message>
        <source>Remove point of spline</source>
        <translation>Punkt des Splines entfernen</translation>
    </message>
    <message>
        <source>A spline has at most %1 points. New begins another.</source>
        <translation>Ein Spline hat höchstens %1 Punkte. Neu beginnt einen anderen.</translation>
    </message>
    <message>
        <source>Add point to spline</source>
        <translation>Punkt zum Spline hinzufügen</translation>
    </message>
    <message>
        <source>Move point of spline</source>
        <translation>Punkt des Splines verschieben</translation>
    </message>
    <message>
        <source>A scene has at most %1 splines.</source>
        <translation>Eine Szene hat höchstens %1 Splines.</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Repeats the stroke on the other side of planes across these axes</source>
        <translation>Wiederholt den Strich auf der anderen Seite von Ebenen quer zu diesen Achsen</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>View target</source>
        <translation>Blickpunkt</translation>
    </message>
    <message>
        <source>Snap to</source>
        <translation>Einrasten an</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Distance between the points of the grid in scene units</source>
        <translation>Abstand der Punkte des Gitters in Szeneneinheiten</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Strich</translation>
    </message>
    <message>
        <source>Soft edge, smoothing, mirrors, snapping and the pen</source>
        <translation>Weicher Rand, Glättung, Spiegelung, Einrasten und der Stift</translation>
    </message>
    <message>
        <source>Pen pressure changes</source>
        <translation>Stiftdruck ändert</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Click to place a particle emitter, drag to move one. Space plays; the panel Emitters has its settings.</source>
        <translation>Ein Klick setzt einen Partikelemitter, Ziehen verschiebt einen. Leertaste spielt ab; das Bedienfeld Emitter hat die Einstellungen.</translation>
    </message>
    <message>
        <source>Under mouse</source>
        <translation>Unter der Maus</translation>
    </message>
    <message>
        <source>View plane</source>
        <translation>Ansichtsebene</translation>
    </message>
    <message>
        <source>Ground, y</source>
        <translation>Boden, y</translation>
    </message>
    <message>
        <source>Wall, x</source>
        <translation>Wand, x</translation>
    </message>
    <message>
        <source>Wall, z</source>
        <translation>Wand, z</translation>
    </message>
    <message>
        <source>Drag over what you want to select. Shift adds, Ctrl removes, both intersect; [ and ] change the radius.</source>
        <translation>Über das ziehen, was ausgewählt werden soll. Umschalt fügt hinzu, Strg nimmt weg, beide schneiden; [ und ] ändern den Radius.</translation>
    </message>
    <message>
        <source>Draw around what you want to select. Shift adds, Ctrl removes, both intersect.</source>
        <translation>Umfahren, was ausgewählt werden soll. Umschalt fügt hinzu, Strg nimmt weg, beide schneiden.</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Set outer angle of %1</source>
        <translation>Äußeren Winkel von %1 setzen</translation>
    </message>
    <message>
        <source>Click to select Gaussians, surfaces, lights; drag a selected handle to move the selection, drag elsewhere to box select. Middle button orbits, wheel zooms.</source>
        <translation>Ein Klick wählt Gaußfunktionen, Oberflächen und Lichter aus; Ziehen eines ausgewählten Griffs verschiebt die Auswahl, Ziehen anderswo wählt mit einem Rechteck aus. Mittlere Taste dreht, Mausrad zoomt.</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Intersect</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Soft selection: Gaussians within this distance of the selection, in scene units, come along, the less the farther they are; 0 is off</source>
        <translation>Weiche Auswahl: Gaußfunktionen innerhalb dieses Abstands zur Auswahl, in Szeneneinheiten, kommen mit, je ferner, desto weniger; 0 ist aus</translation>
    </message>
    <message>
        <source>Drag an arrow to move the selection along it, the ring to move it in the view plane.</source>
        <translation>Ziehen eines Pfeils verschiebt die Auswahl an ihm entlang, Ziehen des Rings in der Ansichtsebene.</translation>
    </message>
    <message>
        <source>Drag a ring to rotate the selection about its axis, the outer ring about the view direction.</source>
        <translation>Ziehen eines Rings dreht die Auswahl um seine Achse, der äußere Ring um die Blickrichtung.</translation>
    </message>
    <message>
        <source>Drag the ring to scale the selection uniformly, radii included; drag an axis to stretch it: balls become ellipsoids.</source>
        <translation>Ziehen des Rings skaliert die Auswahl gleichmäßig, samt Radien; Ziehen einer Achse streckt sie: Kugeln werden Ellipsoide.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Brush Selection</source>
        <translation>Pinselauswahl</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Paintbrush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>Airbrush</source>
        <translation>Airbrush</translation>
    </message>
    <message>
        <source>Emitter</source>
        <translation>Emitter</translation>
    </message>
    <message>
        <source>Spline Brush</source>
        <translation>Spline-Pinsel</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Drag over what to render. Escape ends</source>
        <translation>Über das ziehen, was gerendert werden soll. Esc beendet</translation>
    </message>
    <message>
        <source>What this view shows</source>
        <translation>Was diese Ansicht zeigt</translation>
    </message>
    <message>
        <source>How exactly all views are rendered</source>
        <translation>Wie genau alle Ansichten gerendert werden</translation>
    </message>
    <message>
        <source>How radiance becomes colours, in all views</source>
        <translation>Wie Strahldichte zu Farben wird, in allen Ansichten</translation>
    </message>
    <message>
        <source>The camera of the scene and this view</source>
        <translation>Die Kamera der Szene und diese Ansicht</translation>
    </message>
    <message>
        <source>What is drawn over the picture</source>
        <translation>Was über das Bild gezeichnet wird</translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation>Einblendungen</translation>
    </message>
    <message>
        <source>Width and height of the picture at rest, in pixels</source>
        <translation>Breite und Höhe des ruhenden Bildes in Pixeln</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Exposure of this view in stops; the scene is not changed</source>
        <translation>Belichtung dieser Ansicht in Blendenstufen; die Szene bleibt unverändert</translation>
    </message>
    <message>
        <source>Exposure 0</source>
        <translation>Belichtung 0</translation>
    </message>
    <message>
        <source>Paper's Method</source>
        <translation>Verfahren der Veröffentlichung</translation>
    </message>
    <message>
        <source>Free View</source>
        <translation>Freie Ansicht</translation>
    </message>
    <message>
        <source>Nothing lights this scene: shown by a headlight</source>
        <translation>Nichts beleuchtet diese Szene: von einem Kopflicht gezeigt</translation>
    </message>
    <message>
        <source>Without the walls before the room</source>
        <translation>Ohne die Wände vor dem Raum</translation>
    </message>
    <message>
        <source>%1 is right before the eye, as if inside it; Home shows all</source>
        <translation>%1 ist direkt vor dem Auge, als wäre es darin; Pos1 zeigt alles</translation>
    </message>
    <message>
        <source>No OpenGL: %1. The view is drawn without it.</source>
        <translation>Kein OpenGL: %1. Die Ansicht wird ohne gezeichnet.</translation>
    </message>
    <message>
        <source>Choose a Colour</source>
        <translation>Farbe wählen</translation>
    </message>
    <message>
        <source>embers</source>
        <translation>Glut</translation>
    </message>
    <message>
        <source>a candle</source>
        <translation>eine Kerze</translation>
    </message>
    <message>
        <source>a bulb</source>
        <translation>eine Glühlampe</translation>
    </message>
    <message>
        <source>a halogen light</source>
        <translation>ein Halogenlicht</translation>
    </message>
    <message>
        <source>moonlight</source>
        <translation>Mondlicht</translation>
    </message>
    <message>
        <source>daylight</source>
        <translation>Tageslicht</translation>
    </message>
    <message>
        <source>an overcast sky</source>
        <translation>ein bedeckter Himmel</translation>
    </message>
    <message>
        <source>a blue sky</source>
        <translation>ein blauer Himmel</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Radiance of a body of it that nothing shines through, W/(sr u²)</source>
        <translation>Strahldichte eines Körpers daraus, durch den nichts scheint, W/(sr u²)</translation>
    </message>
    <message>
        <source>Gives the emission the colour of a black body: embers 1000 K, a candle 1850 K</source>
        <translation>Gibt der Emission die Farbe eines schwarzen Körpers: Glut 1000 K, eine Kerze 1850 K</translation>
    </message>
    <message numerus="yes">
        <source>%n slice(s)</source>
        <translation>
            <numerusform>%n Scheibe</numerusform>
            <numerusform>%n Scheiben</numerusform>
        </translation>
    </message>
    <message>
        <source>paper's method</source>
        <translation>Verfahren der Veröffentlichung</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>path tracing</source>
        <translation>Path Tracing</translation>
    </message>
    <message>
        <source>OpenGL on %1</source>
        <translation>OpenGL auf %1</translation>
    </message>
    <message numerus="yes">
        <source>%1 path(s), noise %2</source>
        <translation>
            <numerusform>%1 Pfad, Rauschen %2</numerusform>
            <numerusform>%1 Pfade, Rauschen %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 path(s), denoised</source>
        <translation>
            <numerusform>%1 Pfad, entrauscht</numerusform>
            <numerusform>%1 Pfade, entrauscht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 path(s)</source>
        <translation>
            <numerusform>%1 Pfad</numerusform>
            <numerusform>%1 Pfade</numerusform>
        </translation>
    </message>
    <message>
        <source>all orders, %1</source>
        <translation>alle Ordnungen, %1</translation>
    </message>
    <message>
        <source>once</source>
        <translation>einmal</translation>
    </message>
    <message numerus="yes">
        <source>all orders, converged to %1 in %n sweep(s)</source>
        <translation>
            <numerusform>alle Ordnungen, auf %1 konvergiert in %n Durchlauf</numerusform>
            <numerusform>alle Ordnungen, auf %1 konvergiert in %n Durchläufen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, picture %2</source>
        <translation>%1, Bild %2</translation>
    </message>
    <message>
        <source>linear %1, %2, %3</source>
        <translation>linear %1, %2, %3</translation>
    </message>
    <message>
        <source>sRGB %1, %2, %3</source>
        <translation>sRGB %1, %2, %3</translation>
    </message>
    <message>
        <source>Airlight</source>
        <translation>Luftlicht</translation>
    </message>
    <message>
        <source>The light that the fog scatters to the camera</source>
        <translation>Das Licht, das der Nebel zur Kamera streut</translation>
    </message>
    <message>
        <source>Transmittance</source>
        <translation>Transmission</translation>
    </message>
    <message>
        <source>The share of light that the fog lets through</source>
        <translation>Der Anteil des Lichts, den der Nebel durchlässt</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>The distance along the view ray, in scene units</source>
        <translation>Der Abstand entlang des Sehstrahls in Szeneneinheiten</translation>
    </message>
    <message>
        <source>Airlight and surfaces under each light alone. Takes a render for each source of light</source>
        <translation>Luftlicht und Oberflächen unter jedem Licht allein. Rendert einmal pro Lichtquelle</translation>
    </message>
    <message>
        <source>Airlight and surfaces under the environment alone, and what is seen of it. Takes a render for each source of light</source>
        <translation>Luftlicht und Oberflächen unter der Umgebung allein und was von ihr zu sehen ist. Rendert einmal pro Lichtquelle</translation>
    </message>
    <message>
        <source>Airlight and surfaces under what shines by itself alone. Takes a render for each source of light</source>
        <translation>Luftlicht und Oberflächen unter dem allein, was selbst leuchtet. Rendert einmal pro Lichtquelle</translation>
    </message>
    <message>
        <source>Direct</source>
        <translation>Direkt</translation>
    </message>
    <message>
        <source>Light that was scattered once at most. Takes another render</source>
        <translation>Licht, das höchstens einmal gestreut wurde. Rendert noch einmal</translation>
    </message>
    <message>
        <source>Multiple</source>
        <translation>Mehrfach</translation>
    </message>
    <message>
        <source>Light that was scattered or reflected more often. Takes another render</source>
        <translation>Licht, das öfter gestreut oder reflektiert wurde. Rendert noch einmal</translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation>Reflexion</translation>
    </message>
    <message>
        <source>What smooth surfaces mirror of surfaces, fog and sky. Takes another render where some do</source>
        <translation>Was glatte Oberflächen von Oberflächen, Nebel und Himmel spiegeln. Rendert noch einmal, wo es welche gibt</translation>
    </message>
    <message>
        <source>Minus the logarithm of the transmittance</source>
        <translation>Minus der Logarithmus der Transmission</translation>
    </message>
    <message>
        <source>Planar depth</source>
        <translation>Ebene Tiefe</translation>
    </message>
    <message>
        <source>The depth along the camera's axis, in scene units</source>
        <translation>Die Tiefe entlang der Achse der Kamera in Szeneneinheiten</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Of surfaces, in the world</source>
        <translation>Von Oberflächen, in der Welt</translation>
    </message>
    <message>
        <source>The colour of surfaces, without light</source>
        <translation>Die Farbe von Oberflächen, ohne Licht</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>How far surfaces move until the next frame, in pixels</source>
        <translation>Wie weit sich Oberflächen bis zum nächsten Frame bewegen, in Pixeln</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>A Cryptomatte of surfaces by their names</source>
        <translation>Eine Cryptomatte der Oberflächen nach ihren Namen</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>A Cryptomatte of surfaces by their materials</source>
        <translation>Eine Cryptomatte der Oberflächen nach ihren Materialien</translation>
    </message>
    <message>
        <source>As in the view</source>
        <translation>Wie in der Ansicht</translation>
    </message>
    <message>
        <source>Path traced</source>
        <translation>Path Tracing</translation>
    </message>
    <message>
        <source>Path traced, denoised</source>
        <translation>Path Tracing, entrauscht</translation>
    </message>
    <message>
        <source>As in the view: by View &gt; Quality, soon done, or by %1 paths, denoised, if the view is path traced. Path traced: all light, scattered and reflected any number of times, with noise that four times the paths halve. Denoised: begins with the solved picture and keeps of the paths what stands out from their noise; regions, and layers of light, keep the noise</source>
        <translation>Wie in der Ansicht: nach Ansicht &gt; Qualität, bald fertig, oder mit %1 Pfaden, entrauscht, wenn die Ansicht Path Tracing zeigt. Path Tracing: alles Licht, beliebig oft gestreut und reflektiert, mit Rauschen, das viermal so viele Pfade halbieren. Entrauscht: beginnt mit dem gelösten Bild und behält von den Pfaden, was aus ihrem Rauschen hervortritt; Ausschnitte und Layer des Lichts behalten das Rauschen</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>Shortest radius</source>
        <translation>Kürzester Radius</translation>
    </message>
    <message>
        <source>Mean radius</source>
        <translation>Mittlerer Radius</translation>
    </message>
    <message>
        <source>Longest radius</source>
        <translation>Längster Radius</translation>
    </message>
    <message>
        <source>A splat is as opaque from every side; fog is more opaque along longer radii</source>
        <translation>Ein Splat ist von jeder Seite gleich undurchsichtig; Nebel ist es entlang längerer Radien mehr</translation>
    </message>
    <message>
        <source>Own albedo</source>
        <translation>Eigene Albedo</translation>
    </message>
    <message>
        <source>An albedo of its own instead of the medium's: coloured smoke</source>
        <translation>Eine eigene Albedo statt der des Mediums: farbiger Rauch</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 muss sein: %2.</translation>
    </message>
    <message>
        <source>Allowed: %1</source>
        <translation>Erlaubt: %1</translation>
    </message>
    <message>
        <source>%1 must be a whole number from %2 to %3.</source>
        <translation>%1 muss eine ganze Zahl von %2 bis %3 sein.</translation>
    </message>
    <message>
        <source>Add Fog Shape</source>
        <translation>Nebelform hinzufügen</translation>
    </message>
    <message>
        <source>Height fog</source>
        <translation>Höhennebel</translation>
    </message>
    <message>
        <source>About Brume</source>
        <translation>Über Brume</translation>
    </message>
    <message>
        <source>&lt;h2&gt;Brume %1&lt;/h2&gt;&lt;p&gt;An editor and renderer for fog, smoke and steam modelled as Gaussians.&lt;/p&gt;</source>
        <translation>&lt;h2&gt;Brume %1&lt;/h2&gt;&lt;p&gt;Editor und Renderer für Nebel, Rauch und Dampf aus Gaußfunktionen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Add to the selection, toggle</source>
        <translation>Zur Auswahl hinzufügen, umschalten</translation>
    </message>
    <message>
        <source>Shift+Click, Ctrl+Click</source>
        <translation>Umschalt+Klick, Strg+Klick</translation>
    </message>
    <message>
        <source>Box select</source>
        <translation>Mit Rechteck auswählen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Move the selection</source>
        <translation>Auswahl verschieben</translation>
    </message>
    <message>
        <source>Drag a selected handle; Escape cancels</source>
        <translation>Einen ausgewählten Griff ziehen; Esc bricht ab</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Um den Blickpunkt drehen</translation>
    </message>
    <message>
        <source>Middle button, or Alt+Left</source>
        <translation>Mittlere Taste oder Alt+Links</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Shift+Middle, or Alt+Middle</source>
        <translation>Umschalt+Mitte oder Alt+Mitte</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Wheel, or Alt+Right</source>
        <translation>Mausrad oder Alt+Rechts</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>The manual is not installed: %1 is missing. In Debian it is the package brume-doc.</source>
        <translation>Das Handbuch ist nicht installiert: %1 fehlt. In Debian ist es das Paket brume-doc.</translation>
    </message>
    <message>
        <source>No browser could be started to show %1</source>
        <translation>Kein Browser konnte gestartet werden, um %1 zu zeigen</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>All Defaults</source>
        <translation>Alle auf Standard</translation>
    </message>
    <message>
        <source>Taken from %1.</source>
        <translation>%1 genommen.</translation>
    </message>
    <message>
        <source>The name shown behind lengths and positions. Numbers stay as they are: nothing is converted</source>
        <translation>Der Name, der hinter Längen und Positionen steht. Zahlen bleiben, wie sie sind: Nichts wird umgerechnet</translation>
    </message>
    <message>
        <source>Unit of lengths</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>sRGB, 0 to 255</source>
        <translation>sRGB, 0 bis 255</translation>
    </message>
    <message>
        <source>Linear, 0 to 1</source>
        <translation>Linear, 0 bis 1</translation>
    </message>
    <message>
        <source>How the numbers of a colour are shown and entered: as in most programs, or as light adds up and scene files have them</source>
        <translation>Wie die Zahlen einer Farbe gezeigt und eingegeben werden: wie in den meisten Programmen oder so, wie Licht sich addiert und Szenendateien sie haben</translation>
    </message>
    <message>
        <source>Numbers of colours</source>
        <translation>Zahlen von Farben</translation>
    </message>
    <message>
        <source>By the screen</source>
        <translation>Nach dem Bildschirm</translation>
    </message>
    <message>
        <source>Size of handles and outlines in the views, and how near the mouse has to be to them</source>
        <translation>Größe von Griffen und Umrissen in den Ansichten und wie nah die Maus ihnen sein muss</translation>
    </message>
    <message>
        <source>Size of handles</source>
        <translation>Größe der Griffe</translation>
    </message>
    <message>
        <source>From the next start on</source>
        <translation>Ab dem nächsten Start</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Size of letters, buttons and panels. From the next start on</source>
        <translation>Größe von Buchstaben, Knöpfen und Bedienfeldern. Ab dem nächsten Start</translation>
    </message>
    <message>
        <source>Scale of the interface</source>
        <translation>Skalierung der Oberfläche</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>How often a copy of unsaved work is kept, from 5 seconds to an hour</source>
        <translation>Wie oft eine Kopie ungespeicherter Arbeit gesichert wird, von 5 Sekunden bis zu einer Stunde</translation>
    </message>
    <message>
        <source>Keep unsaved work every</source>
        <translation>Ungespeicherte Arbeit sichern alle</translation>
    </message>
    <message>
        <source>all cores</source>
        <translation>alle Kerne</translation>
    </message>
    <message>
        <source>How many processor threads render at most, to leave some to others</source>
        <translation>Wie viele Prozessorthreads höchstens rendern, um anderen welche zu lassen</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>How many steps of the history are kept: fewer take less memory. From the next scene on</source>
        <translation>Wie viele Schritte des Verlaufs behalten werden: Weniger brauchen weniger Speicher. Ab der nächsten Szene</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Steps that can be undone</source>
        <translation>Rückgängig zu machende Schritte</translation>
    </message>
    <message>
        <source>Memory for the frames of an animation that have been shown, to play them without rendering</source>
        <translation>Speicher für die Frames einer Animation, die gezeigt wurden, um sie ohne Rendern abzuspielen</translation>
    </message>
    <message>
        <source>Memory for played frames</source>
        <translation>Speicher für abgespielte Frames</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Vereinfachen</translation>
    </message>
    <message>
        <source>Merges all %1</source>
        <translation>Fasst alle zusammen: %1</translation>
    </message>
    <message>
        <source>Merges %1, selected</source>
        <translation>Fasst die ausgewählten zusammen: %1</translation>
    </message>
    <message>
        <source>Counting…</source>
        <translation>Wird gezählt …</translation>
    </message>
    <message>
        <source>None can be merged within this error</source>
        <translation>Innerhalb dieses Fehlers lässt sich keine zusammenfassen</translation>
    </message>
    <message>
        <source>Leaves %1, with an error of %2 %</source>
        <translation>Lässt %1 übrig, mit einem Fehler von %2 %</translation>
    </message>
    <message>
        <source>Outliner</source>
        <translation>Outliner</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Emitters</source>
        <translation>Emitter</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>At the Cursor</source>
        <translation>Am Mauszeiger</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>The fog has changed meanwhile; nothing is simplified</source>
        <translation>Der Nebel hat sich inzwischen geändert; nichts wird vereinfacht</translation>
    </message>
    <message>
        <source>No Gaussians can be merged within this error</source>
        <translation>Innerhalb dieses Fehlers lassen sich keine Gaußfunktionen zusammenfassen</translation>
    </message>
    <message>
        <source>%1 became %2, with an error of %3%</source>
        <translation>%1 wurden zu %2, mit einem Fehler von %3%</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Gather into a New Folder</source>
        <translation>In neuen Ordner sammeln</translation>
    </message>
    <message>
        <source>Gathering</source>
        <translation>Wird gesammelt</translation>
    </message>
    <message>
        <source>Gathered in %1</source>
        <translation>In %1 gesammelt</translation>
    </message>
    <message numerus="yes">
        <source>, with %n file(s) from outside the scene's folder</source>
        <translation>
            <numerusform>, mit %n Datei von außerhalb des Ordners der Szene</numerusform>
            <numerusform>, mit %n Dateien von außerhalb des Ordners der Szene</numerusform>
        </translation>
    </message>
    <message>
        <source>Simplifying</source>
        <translation>Wird vereinfacht</translation>
    </message>
    <message>
        <source>%1 is no file of this computer. Download it, and drop the file.</source>
        <translation>%1 ist keine Datei dieses Rechners. Laden Sie sie herunter und legen Sie die Datei hier ab.</translation>
    </message>
    <message>
        <source>Not opened</source>
        <translation>Nicht geöffnet</translation>
    </message>
    <message>
        <source>“%1” has been changed by another program.</source>
        <translation>„%1“ wurde von einem anderen Programm geändert.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Meine behalten</translation>
    </message>
    <message>
        <source>“%1” is missing: it was deleted, moved or renamed. The scene is unsaved until the file is back.</source>
        <translation>„%1“ fehlt: gelöscht, verschoben oder umbenannt. Die Szene ist ungespeichert, bis die Datei wieder da ist.</translation>
    </message>
    <message>
        <source>Missing files: %1. The scene is shown without them; saving keeps the references.</source>
        <translation>Fehlende Dateien: %1. Die Szene wird ohne sie gezeigt; Speichern behält die Verweise.</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Suchen …</translation>
    </message>
    <message>
        <source>Region: %1 × %2 % of the picture</source>
        <translation>Ausschnitt: %1 × %2 % des Bildes</translation>
    </message>
    <message>
        <source>Rendered</source>
        <translation>Gerendert</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>%1 exportiert</translation>
    </message>
    <message>
        <source>Export cancelled</source>
        <translation>Export abgebrochen</translation>
    </message>
    <message numerus="yes">
        <source>Export cancelled after %n file(s)</source>
        <translation>
            <numerusform>Export nach %n Datei abgebrochen</numerusform>
            <numerusform>Export nach %n Dateien abgebrochen</numerusform>
        </translation>
    </message>
    <message>
        <source>Render &amp;Picture</source>
        <translation>Bild rendern</translation>
    </message>
    <message>
        <source>Renders what the scene's camera sees now, or the view where the panel Output says so, into the picture viewer and the file (F12)</source>
        <translation>Rendert, was die Kamera der Szene jetzt sieht oder, wenn das Bedienfeld Ausgabe es sagt, die Ansicht, in den Bildbetrachter und die Datei (F12)</translation>
    </message>
    <message>
        <source>Render &amp;Animation</source>
        <translation>Animation rendern</translation>
    </message>
    <message>
        <source>Renders all frames of the timeline to the file (Ctrl+F12)</source>
        <translation>Rendert alle Frames der Zeitleiste in die Datei (Strg+F12)</translation>
    </message>
    <message>
        <source>Render &amp;Region…</source>
        <translation>Ausschnitt rendern …</translation>
    </message>
    <message>
        <source>Drag over the part of the camera's picture that is to be rendered</source>
        <translation>Über den Teil des Kamerabildes ziehen, der gerendert werden soll</translation>
    </message>
    <message>
        <source>&amp;Whole Picture</source>
        <translation>Ganzes Bild</translation>
    </message>
    <message>
        <source>Renders all of the picture again</source>
        <translation>Rendert wieder das ganze Bild</translation>
    </message>
    <message>
        <source>Picture &amp;Viewer</source>
        <translation>Bild&amp;betrachter</translation>
    </message>
    <message>
        <source>Shows rendered pictures in a window of their own</source>
        <translation>Zeigt gerenderte Bilder in einem eigenen Fenster</translation>
    </message>
    <message>
        <source>&amp;Keep View</source>
        <translation>Ansicht behalten</translation>
    </message>
    <message>
        <source>Keeps what the view shows in a slot of the picture viewer</source>
        <translation>Behält, was die Ansicht zeigt, in einem Fach des Bildbetrachters</translation>
    </message>
    <message>
        <source>Camera &amp;Frame</source>
        <translation>Kamerarahmen</translation>
    </message>
    <message>
        <source>Shows what the scene's camera will render when you look through it</source>
        <translation>Zeigt beim Blick durch die Kamera der Szene, was sie rendern wird</translation>
    </message>
    <message>
        <source>&amp;Lock Camera to View</source>
        <translation>Kamera an Ansicht koppeln</translation>
    </message>
    <message>
        <source>While you look through the scene's camera, navigation moves it</source>
        <translation>Beim Blick durch die Kamera der Szene bewegt die Navigation sie</translation>
    </message>
    <message>
        <source>&amp;Thirds</source>
        <translation>Drittellinien</translation>
    </message>
    <message>
        <source>Lines at the thirds of the camera's picture, while you look through it</source>
        <translation>Linien auf den Dritteln des Kamerabildes beim Blick hindurch</translation>
    </message>
    <message>
        <source>&amp;Safe Areas</source>
        <translation>Sichere Bereiche</translation>
    </message>
    <message>
        <source>The parts of the camera's picture where action (%1) and titles (%2) stay visible</source>
        <translation>Die Teile des Kamerabildes, in denen Handlung (%1) und Titel (%2) sichtbar bleiben</translation>
    </message>
    <message>
        <source>&amp;Plate</source>
        <translation>Hintergrundfoto</translation>
    </message>
    <message>
        <source>The photographed picture that the panel Camera has chosen, over the camera's picture</source>
        <translation>Das Foto, das im Bedienfeld Kamera gewählt ist, über dem Kamerabild</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Queue (%1)</source>
        <translation>Liste (%1)</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, Frame %2</translation>
    </message>
    <message>
        <source>An animation needs a file: name it in the panel Output.</source>
        <translation>Eine Animation braucht eine Datei: Nennen Sie sie im Bedienfeld Ausgabe.</translation>
    </message>
    <message>
        <source>Rendering in the background; see the queue in the panel Output</source>
        <translation>Wird im Hintergrund gerendert; siehe die Liste im Bedienfeld Ausgabe</translation>
    </message>
    <message>
        <source>Its slot has another picture by now.</source>
        <translation>In seinem Fach ist inzwischen ein anderes Bild.</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Frame %1</translation>
    </message>
    <message>
        <source>%1 measures %2 × %3 × %4; what is looked at is about %5 across.</source>
        <translation>%1 misst %2 × %3 × %4; das Betrachtete ist etwa %5 breit.</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Drop on Floor</source>
        <translation>Auf den Boden stellen</translation>
    </message>
    <message>
        <source>Read %1 in </source>
        <translation>%1 lesen in </translation>
    </message>
    <message>
        <source>Fit %1</source>
        <translation>%1 einpassen</translation>
    </message>
    <message>
        <source>Drop %1 on the floor</source>
        <translation>%1 auf den Boden stellen</translation>
    </message>
    <message>
        <source>Renders of an earlier session are not finished.</source>
        <translation>Das Rendern einer früheren Sitzung ist nicht fertig.</translation>
    </message>
    <message>
        <source>Show Queue</source>
        <translation>Liste zeigen</translation>
    </message>
    <message>
        <source>The configuration cannot be read</source>
        <translation>Die Konfiguration kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>&amp;Neutral</source>
        <translation>Neutral</translation>
    </message>
    <message>
        <source>Khronos PBR Neutral in sRGB: colours as they are, highlights compressed</source>
        <translation>Khronos PBR Neutral in sRGB: Farben, wie sie sind, Lichter komprimiert</translation>
    </message>
    <message>
        <source>&amp;ACES 1.0</source>
        <translation>ACES 1.0</translation>
    </message>
    <message>
        <source>&amp;Configuration…</source>
        <translation>Konfiguration …</translation>
    </message>
    <message>
        <source>Views of another configuration of OpenColorIO (.ocio)</source>
        <translation>Ansichten einer anderen Konfiguration von OpenColorIO (.ocio)</translation>
    </message>
    <message>
        <source>Choose a Configuration</source>
        <translation>Konfiguration wählen</translation>
    </message>
    <message>
        <source>OpenColorIO (*.ocio)</source>
        <translation>OpenColorIO (*.ocio)</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>F&amp;og</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>Add S&amp;hape…</source>
        <translation>Form hinzufügen …</translation>
    </message>
    <message>
        <source>A box, a sphere or height fog of Gaussians, by numbers</source>
        <translation>Ein Quader, eine Kugel oder Höhennebel aus Gaußfunktionen, nach Zahlen</translation>
    </message>
    <message>
        <source>&amp;Ground Grid</source>
        <translation>Bodengitter</translation>
    </message>
    <message>
        <source>A grid at y = 0, its lines 1, 2 or 5 times a power of ten of scene units apart</source>
        <translation>Ein Gitter bei y = 0, dessen Linien 1, 2 oder 5 mal eine Zehnerpotenz Szeneneinheiten auseinander liegen</translation>
    </message>
    <message>
        <source>Out of Groups</source>
        <translation>Aus Gruppen heraus</translation>
    </message>
    <message>
        <source>Save Layout</source>
        <translation>Layout sichern</translation>
    </message>
    <message>
        <source>Name of the layout; one of the same name is replaced</source>
        <translation>Name des Layouts; ein gleichnamiges wird ersetzt</translation>
    </message>
    <message>
        <source>&amp;Save Current As…</source>
        <translation>Aktuelles sichern als …</translation>
    </message>
    <message>
        <source>&amp;Reset to Default</source>
        <translation>Auf Standard zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>T&amp;ime</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>&amp;Render</source>
        <translation>Rendern</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Start Pa&amp;ge</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Import Se&amp;quence…</source>
        <translation>Sequenz importieren …</translation>
    </message>
    <message>
        <source>&amp;Export Picture or Animation…</source>
        <translation>Bild oder Animation exportieren …</translation>
    </message>
    <message>
        <source>Export Me&amp;dium…</source>
        <translation>Medium exportieren …</translation>
    </message>
    <message>
        <source>Save as Asse&amp;t…</source>
        <translation>Als Asse&amp;t speichern…</translation>
    </message>
    <message>
        <source>&amp;Gather into Folder…</source>
        <translation>In Ordner sammeln …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Fi&amp;nd Command…</source>
        <translation>Befehl suchen …</translation>
    </message>
    <message>
        <source>Prefere&amp;nces…</source>
        <translation>Einstellungen …</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Paste in Pl&amp;ace</source>
        <translation>An gleicher Stelle einfügen</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Simplif&amp;y…</source>
        <translation>Vereinfachen …</translation>
    </message>
    <message>
        <source>Drop on Fl&amp;oor</source>
        <translation>Auf den Boden stellen</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>Erweitern</translation>
    </message>
    <message>
        <source>Shrin&amp;k</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Si&amp;milar</source>
        <translation>Ähnliche</translation>
    </message>
    <message>
        <source>Similar %1</source>
        <translation>Ähnlich: %1</translation>
    </message>
    <message>
        <source>Same Group</source>
        <translation>Gleiche Gruppe</translation>
    </message>
    <message>
        <source>Gr&amp;oup Selection</source>
        <translation>Auswahl gruppieren</translation>
    </message>
    <message>
        <source>Ungroup S&amp;election</source>
        <translation>Gruppierung der Auswahl aufheben</translation>
    </message>
    <message>
        <source>Mo&amp;ve to Group</source>
        <translation>In Gruppe verschieben</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Isola&amp;te</source>
        <translation>Allein zeigen</translation>
    </message>
    <message>
        <source>&amp;Show All</source>
        <translation>Alle einblenden</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>&amp;Unlock All</source>
        <translation>Alle entsperren</translation>
    </message>
    <message>
        <source>S&amp;maller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>&amp;Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>&amp;Thinner</source>
        <translation>Dünner</translation>
    </message>
    <message>
        <source>&amp;Denser</source>
        <translation>Dichter</translation>
    </message>
    <message>
        <source>&amp;Play or Pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>&amp;Next Frame</source>
        <translation>Nächster Frame</translation>
    </message>
    <message>
        <source>P&amp;revious Frame</source>
        <translation>Voriger Frame</translation>
    </message>
    <message>
        <source>&amp;First Frame</source>
        <translation>Erster Frame</translation>
    </message>
    <message>
        <source>Set &amp;Keyframe</source>
        <translation>Keyframe setzen</translation>
    </message>
    <message>
        <source>&amp;Bake Particles to Gaussians</source>
        <translation>Partikel zu Gaußfunktionen einfrieren</translation>
    </message>
    <message>
        <source>&amp;Remove Sequences</source>
        <translation>Sequenzen entfernen</translation>
    </message>
    <message>
        <source>Remove sequences</source>
        <translation>Sequenzen entfernen</translation>
    </message>
    <message>
        <source>Frame &amp;All</source>
        <translation>Alles einpassen</translation>
    </message>
    <message>
        <source>&amp;Frame Selection</source>
        <translation>Auswahl einpassen</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>&amp;Scene Camera</source>
        <translation>Szenenkamera</translation>
    </message>
    <message>
        <source>&amp;Look Through Light</source>
        <translation>Durch Licht sehen</translation>
    </message>
    <message>
        <source>Set Scene Camera &amp;to View</source>
        <translation>Szenenkamera auf Ansicht setzen</translation>
    </message>
    <message>
        <source>Set scene camera to view</source>
        <translation>Szenenkamera auf Ansicht setzen</translation>
    </message>
    <message>
        <source>F&amp;our Views</source>
        <translation>Vier Ansichten</translation>
    </message>
    <message>
        <source>&amp;Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Exposure &amp;Up</source>
        <translation>Belichtung erhöhen</translation>
    </message>
    <message>
        <source>Exposure &amp;Down</source>
        <translation>Belichtung verringern</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>&amp;Render Device</source>
        <translation>Rendergerät</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>Navigation</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>O&amp;verlays</source>
        <translation>Einblendungen</translation>
    </message>
    <message>
        <source>&amp;Handles and Outlines</source>
        <translation>Griffe und Umrisse</translation>
    </message>
    <message>
        <source>La&amp;youts</source>
        <translation>Layouts</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Bedienfelder</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;About Brume</source>
        <translation>Über Brume</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>&amp;Auto: OpenGL if there is a GPU</source>
        <translation>Auto: OpenGL, wenn es eine GPU gibt</translation>
    </message>
    <message>
        <source>&amp;CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>&amp;OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>&amp;Brume: middle button, or Alt</source>
        <translation>Brume: mittlere Taste oder Alt</translation>
    </message>
    <message>
        <source>Like B&amp;lender: middle button, Shift, Ctrl</source>
        <translation>Wie Blender: mittlere Taste, Umschalt, Strg</translation>
    </message>
    <message>
        <source>Like &amp;Maya: Alt and a button</source>
        <translation>Wie Maya: Alt und eine Taste</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Exposure %1 stops</source>
        <translation>Belichtung %1 Blendenstufen</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Mouse buttons</source>
        <translation>Maustasten</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>&amp;Mesh from File…</source>
        <translation>Netz aus Datei …</translation>
    </message>
    <message>
        <source>&amp;Point Light</source>
        <translation>Punktlicht</translation>
    </message>
    <message>
        <source>&amp;Spot</source>
        <translation>Spot</translation>
    </message>
    <message>
        <source>S&amp;un</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>&amp;Rectangle Light</source>
        <translation>Rechtecklicht</translation>
    </message>
    <message>
        <source>&amp;Disc Light</source>
        <translation>Scheibenlicht</translation>
    </message>
    <message>
        <source>Sp&amp;here Light</source>
        <translation>Kugellicht</translation>
    </message>
    <message>
        <source>&amp;Gaussian</source>
        <translation>Gaußfunktion</translation>
    </message>
    <message>
        <source>&amp;Emitter</source>
        <translation>Emitter</translation>
    </message>
    <message>
        <source>Select a light, emitter or surface to rename it</source>
        <translation>Wählen Sie ein Licht, einen Emitter oder eine Oberfläche aus, um sie umzubenennen</translation>
    </message>
    <message>
        <source>Select a surface to drop it on the floor</source>
        <translation>Wählen Sie eine Oberfläche aus, um sie auf den Boden zu stellen</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it to drop it</source>
        <translation>%1 ist gesperrt. Entsperren Sie es, um es auf den Boden zu stellen</translation>
    </message>
    <message>
        <source>&amp;Auto (max error %1)</source>
        <translation>Auto (max. Fehler %1)</translation>
    </message>
    <message>
        <source>The cheapest settings whose measured error stays below Performance &gt; Max error</source>
        <translation>Die günstigsten Einstellungen, deren gemessener Fehler unter Leistung &gt; Max. Fehler bleibt</translation>
    </message>
    <message>
        <source>&amp;Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Always %1 slices along each view ray, for heavy scenes and slow machines; the error is still measured</source>
        <translation>Immer %1 Scheiben entlang jedes Sehstrahls, für schwere Szenen und langsame Rechner; der Fehler wird trotzdem gemessen</translation>
    </message>
    <message>
        <source>Fi&amp;xed (%1 slices)</source>
        <translation>Fest (%1 Scheiben)</translation>
    </message>
    <message>
        <source>Always the same settings: %1 slices along each view ray, with shadows in the fog</source>
        <translation>Immer dieselben Einstellungen: %1 Scheiben entlang jedes Sehstrahls, mit Schatten im Nebel</translation>
    </message>
    <message>
        <source>&amp;Paper's Method</source>
        <translation>Verfahren der Veröffentlichung</translation>
    </message>
    <message>
        <source>The approximation as published in 2007: light scattered once, without shadows in the fog</source>
        <translation>Die Näherung, wie sie 2007 veröffentlicht wurde: Licht einmal gestreut, ohne Schatten im Nebel</translation>
    </message>
    <message>
        <source>&amp;Reference (path traced)</source>
        <translation>Referenz (Path Tracing)</translation>
    </message>
    <message>
        <source>What all other settings are compared with: all orders of scattering by path tracing, more and more exact in the background while nothing changes. The active view only</source>
        <translation>Womit alle anderen Einstellungen verglichen werden: alle Ordnungen der Streuung durch Path Tracing, im Hintergrund immer genauer, solange sich nichts ändert. Nur die aktive Ansicht</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>a new scene</source>
        <translation>einer neuen Szene</translation>
    </message>
    <message>
        <source>Unsaved changes to %1 from %2 can be restored.</source>
        <translation>Ungespeicherte Änderungen an %1 vom %2 können wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Recent scenes</source>
        <translation>Zuletzt geöffnete Szenen</translation>
    </message>
    <message>
        <source>New scene</source>
        <translation>Neue Szene</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open a scene file</source>
        <translation>Eine Szenendatei öffnen</translation>
    </message>
    <message>
        <source>Show at start</source>
        <translation>Beim Start zeigen</translation>
    </message>
    <message>
        <source>Whether this page comes up when no scene is opened; it is always under File &gt; Start Page</source>
        <translation>Ob diese Seite kommt, wenn keine Szene geöffnet wird; sie ist immer unter Datei &gt; Startseite</translation>
    </message>
    <message>
        <source>Go on with the scene behind this page (Esc)</source>
        <translation>Mit der Szene hinter dieser Seite weitermachen (Esc)</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>Leer</translation>
    </message>
    <message>
        <source>One light and the ground grid</source>
        <translation>Ein Licht und das Bodengitter</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>A room of 6 by 5 m with a window, the sun and a point light</source>
        <translation>Ein Raum von 6 mal 5 m mit einem Fenster, der Sonne und einem Punktlicht</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Landschaft</translation>
    </message>
    <message>
        <source>A valley of 120 m with mist under a morning sun</source>
        <translation>Ein Tal von 120 m mit Nebel unter einer Morgensonne</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Bühne</translation>
    </message>
    <message>
        <source>A stage of 12 m with four beams in haze</source>
        <translation>Eine Bühne von 12 m mit vier Lichtkegeln im Dunst</translation>
    </message>
    <message>
        <source>Street</source>
        <translation>Straße</translation>
    </message>
    <message>
        <source>A street at dusk with spot lights and ground mist</source>
        <translation>Eine Straße in der Dämmerung mit Spots und Bodennebel</translation>
    </message>
    <message>
        <source>Harbour</source>
        <translation>Hafen</translation>
    </message>
    <message>
        <source>Lights with photometric profiles, a neon sign, smoke</source>
        <translation>Lichter mit photometrischen Profilen, eine Leuchtreklame, Rauch</translation>
    </message>
    <message>
        <source>Forest</source>
        <translation>Wald</translation>
    </message>
    <message>
        <source>Sunbeams between leaves</source>
        <translation>Sonnenstrahlen zwischen Blättern</translation>
    </message>
    <message>
        <source>Headlights</source>
        <translation>Scheinwerfer</translation>
    </message>
    <message>
        <source>Spots and an area light on a wet road in mist</source>
        <translation>Spots und ein Flächenlicht auf nasser Straße im Nebel</translation>
    </message>
    <message>
        <source>A flame of Gaussians that shine, and coloured smoke</source>
        <translation>Eine Flamme aus leuchtenden Gaußfunktionen und farbiger Rauch</translation>
    </message>
    <message>
        <source>Swaying beams</source>
        <translation>Schwenkende Lichtkegel</translation>
    </message>
    <message>
        <source>Animated spots; press Space to play</source>
        <translation>Animierte Spots; Leertaste spielt ab</translation>
    </message>
    <message>
        <source>Sunrise</source>
        <translation>Sonnenaufgang</translation>
    </message>
    <message>
        <source>A day's sky, and mist that burns off; press Space to play</source>
        <translation>Der Himmel eines Tages und Nebel, der sich auflöst; Leertaste spielt ab</translation>
    </message>
    <message>
        <source>Statue in fog</source>
        <translation>Statue im Nebel</translation>
    </message>
    <message>
        <source>Drifting fog in three coloured lights</source>
        <translation>Ziehender Nebel in drei farbigen Lichtern</translation>
    </message>
    <message>
        <source>Evening mist</source>
        <translation>Abendnebel</translation>
    </message>
    <message>
        <source>Ground mist under an evening sky</source>
        <translation>Bodennebel unter einem Abendhimmel</translation>
    </message>
    <message>
        <source>Teapot</source>
        <translation>Teekanne</translation>
    </message>
    <message>
        <source>Steam against the light</source>
        <translation>Dampf im Gegenlicht</translation>
    </message>
    <message>
        <source>Courtyard</source>
        <translation>Hof</translation>
    </message>
    <message>
        <source>A building that shadows and lights itself</source>
        <translation>Ein Gebäude, das sich selbst verschattet und beleuchtet</translation>
    </message>
    <message>
        <source>Hills</source>
        <translation>Hügel</translation>
    </message>
    <message>
        <source>Patchy fog in the valleys of a terrain</source>
        <translation>Fleckiger Nebel in den Tälern eines Geländes</translation>
    </message>
    <message>
        <source>Tunnel</source>
        <translation>Tunnel</translation>
    </message>
    <message>
        <source>Mist, seen from inside towards the mouth</source>
        <translation>Nebel, von innen zum Ausgang hin gesehen</translation>
    </message>
    <message>
        <source>Picture Viewer</source>
        <translation>Bildbetrachter</translation>
    </message>
    <message>
        <source>Wait until the picture is at rest, then keep it.</source>
        <translation>Warten Sie, bis das Bild ruht, und behalten Sie es dann.</translation>
    </message>
    <message>
        <source> · error %1</source>
        <translation> · Fehler %1</translation>
    </message>
    <message>
        <source>View, frame %1</source>
        <translation>Ansicht, Frame %1</translation>
    </message>
    <message>
        <source>Kept in slot %1</source>
        <translation>In Fach %1 behalten</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>Saving %1</source>
        <translation>%1 wird gespeichert</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>, %1 selected</source>
        <translation>, %1 ausgewählt</translation>
    </message>
    <message>
        <source>, OpenGL</source>
        <translation>, OpenGL</translation>
    </message>
    <message>
        <source>No fog yet. Press B to paint fog, or Shift+A to add a Gaussian under the mouse.</source>
        <translation>Noch kein Nebel. B malt Nebel, Umschalt+A fügt eine Gaußfunktion unter der Maus hinzu.</translation>
    </message>
    <message>
        <source>The error is being measured</source>
        <translation>Der Fehler wird gemessen</translation>
    </message>
    <message>
        <source>Error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>Relative RMSE of the airlight against the reference, measured on this frame, and of the whole picture beside all the light there is. Of a path-traced picture: its noise, the standard error relative to the RMS</source>
        <translation>Relativer RMSE des Luftlichts gegen die Referenz, an diesem Bild gemessen, und des ganzen Bildes neben allem Licht, das es gibt. Bei Path Tracing: das Rauschen, der Standardfehler relativ zum RMS</translation>
    </message>
    <message>
        <source>Rendered on the CPU instead of OpenGL: %1</source>
        <translation>Auf der CPU statt mit OpenGL gerendert: %1</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>%1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>a number in (0, 1] (from 1e-6), or three 0</source>
        <translation>eine Zahl in (0, 1] (ab 1e-6) oder dreimal 0</translation>
    </message>
    <message>
        <source>an integer from 0 to 4294967295</source>
        <translation>eine ganze Zahl von 0 bis 4294967295</translation>
    </message>
    <message>
        <source>a number from -1e12 to 1e12</source>
        <translation>eine Zahl von -1e12 bis 1e12</translation>
    </message>
    <message>
        <source>a number &gt; 0 (from 1e-12 to 1e12)</source>
        <translation>eine Zahl &gt; 0 (von 1e-12 bis 1e12)</translation>
    </message>
    <message>
        <source>a number from 1e-4 to 1</source>
        <translation>eine Zahl von 1e-4 bis 1</translation>
    </message>
    <message>
        <source>a number &gt;= 0 (up to 1e12)</source>
        <translation>eine Zahl &gt;= 0 (bis 1e12)</translation>
    </message>
    <message>
        <source>a number &gt;= 0 (up to 1e20)</source>
        <translation>eine Zahl &gt;= 0 (bis 1e20)</translation>
    </message>
    <message>
        <source>a number in [0, 1000]</source>
        <translation>eine Zahl in [0, 1000]</translation>
    </message>
    <message>
        <source>a number in [0, 1]</source>
        <translation>eine Zahl in [0, 1]</translation>
    </message>
    <message>
        <source>a number in (0, 1] (from 1e-6)</source>
        <translation>eine Zahl in (0, 1] (ab 1e-6)</translation>
    </message>
    <message>
        <source>a number in [-1, 1]</source>
        <translation>eine Zahl in [-1, 1]</translation>
    </message>
    <message>
        <source>a number in [-0.95, 0.95]</source>
        <translation>eine Zahl in [-0.95, 0.95]</translation>
    </message>
    <message>
        <source>a number in (0, 180) degrees</source>
        <translation>eine Zahl in (0, 180) Grad</translation>
    </message>
    <message>
        <source>a number in [0, 180] degrees</source>
        <translation>eine Zahl in [0, 180] Grad</translation>
    </message>
    <message>
        <source>a number in [-90, 90] degrees</source>
        <translation>eine Zahl in [-90, 90] Grad</translation>
    </message>
    <message>
        <source>a number in [1, 10]</source>
        <translation>eine Zahl in [1, 10]</translation>
    </message>
    <message>
        <source>a number in [0, 90) degrees</source>
        <translation>eine Zahl in [0, 90) Grad</translation>
    </message>
    <message>
        <source>a number of degrees from 0 to 360</source>
        <translation>eine Zahl von 0 bis 360 Grad</translation>
    </message>
    <message>
        <source>a number from 800 to 40000 K</source>
        <translation>eine Zahl von 800 bis 40000 K</translation>
    </message>
    <message>
        <source>a number from 0.05 to 100</source>
        <translation>eine Zahl von 0.05 bis 100</translation>
    </message>
    <message>
        <source>a number from 0 to 10</source>
        <translation>eine Zahl von 0 bis 10</translation>
    </message>
    <message>
        <source>a number from 1 to 1e4</source>
        <translation>eine Zahl von 1 bis 1e4</translation>
    </message>
    <message>
        <source>a number from 1 to 5</source>
        <translation>eine Zahl von 1 bis 5</translation>
    </message>
    <message>
        <source>a number of seconds from -1e9 to 1e9</source>
        <translation>eine Zahl von -1e9 bis 1e9 Sekunden</translation>
    </message>
    <message>
        <source>a number per second from -1e30 to 1e30</source>
        <translation>eine Zahl pro Sekunde von -1e30 bis 1e30</translation>
    </message>
    <message>
        <source>a number from 1e-3 to 1e6</source>
        <translation>eine Zahl von 1e-3 bis 1e6</translation>
    </message>
    <message>
        <source>a number from 1 to 1000</source>
        <translation>eine Zahl von 1 bis 1000</translation>
    </message>
    <message>
        <source>a number of frames from -2 to 2</source>
        <translation>eine Zahl von -2 bis 2 Frames</translation>
    </message>
    <message>
        <source>a number of stops from -60 to 60</source>
        <translation>eine Zahl von -60 bis 60 Blendenstufen</translation>
    </message>
    <message>
        <source>a number of degrees from -1e12 to 1e12</source>
        <translation>eine Zahl von -1e12 bis 1e12 Grad</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>wahr oder falsch</translation>
    </message>
    <message>
        <source>a number of stops from -100 to 100</source>
        <translation>eine Zahl von -100 bis 100 Blendenstufen</translation>
    </message>
    <message>
        <source>a number from 0.1 to 10000 mm</source>
        <translation>eine Zahl von 0.1 bis 10000 mm</translation>
    </message>
    <message>
        <source>a whole number from 1 to 16384</source>
        <translation>eine ganze Zahl von 1 bis 16384</translation>
    </message>
    <message>
        <source>a whole number from 1 to 1000000</source>
        <translation>eine ganze Zahl von 1 bis 1000000</translation>
    </message>
    <message>
        <source>a whole number from 0 to 1000000</source>
        <translation>eine ganze Zahl von 0 bis 1000000</translation>
    </message>
    <message>
        <source>a whole number from 1 to 4096</source>
        <translation>eine ganze Zahl von 1 bis 4096</translation>
    </message>
    <message>
        <source>a number from 0 to 10000</source>
        <translation>eine Zahl von 0 bis 10000</translation>
    </message>
    <message>
        <source>a number from 1e-6 to 100</source>
        <translation>eine Zahl von 1e-6 bis 100</translation>
    </message>
    <message>
        <source>a number from 0 to 100</source>
        <translation>eine Zahl von 0 bis 100</translation>
    </message>
    <message>
        <source>a number from 0.01 to 1</source>
        <translation>eine Zahl von 0.01 bis 1</translation>
    </message>
    <message>
        <source>an integer from 0 to 1e9</source>
        <translation>eine ganze Zahl von 0 bis 1e9</translation>
    </message>
    <message>
        <source>a number of pixels from 0 to 500</source>
        <translation>eine Zahl von 0 bis 500 Pixeln</translation>
    </message>
    <message>
        <source>a number from -20 to 20</source>
        <translation>eine Zahl von -20 bis 20</translation>
    </message>
    <message>
        <source>a number from 1 to 20</source>
        <translation>eine Zahl von 1 bis 20</translation>
    </message>
    <message>
        <source>an integer from 1 to 10,000</source>
        <translation>eine ganze Zahl von 1 bis 10.000</translation>
    </message>
    <message>
        <source>a number from 0.01 to 100</source>
        <translation>eine Zahl von 0.01 bis 100</translation>
    </message>
    <message>
        <source>a number of seconds from 0 to 999999999</source>
        <translation>eine Zahl von 0 bis 999999999 Sekunden</translation>
    </message>
    <message>
        <source>a number of pixels from 1 to 2000</source>
        <translation>eine Zahl von 1 bis 2000 Pixeln</translation>
    </message>
    <message>
        <source>Position of the eye</source>
        <translation>Position des Auges</translation>
    </message>
    <message>
        <source>Looks at</source>
        <translation>Blickpunkt</translation>
    </message>
    <message>
        <source>The point that the camera looks at, any but the eye</source>
        <translation>Der Punkt, auf den die Kamera blickt, jeder außer dem Auge</translation>
    </message>
    <message>
        <source>The direction that is up in the picture, of any length but 0</source>
        <translation>Die Richtung, die im Bild oben ist, von jeder Länge außer 0</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Blickfeld</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Full angle of view from the bottom to the top of the picture</source>
        <translation>Voller Blickwinkel vom unteren zum oberen Rand des Bildes</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Of an orthographic camera, in place of vertical_fov: height of what it sees, from edge to edge; it sees from the plane of `eye` on, and has no lens that blurs</source>
        <translation>Einer orthografischen Kamera, statt vertical_fov: Höhe dessen, was sie sieht, von Rand zu Rand; sie sieht ab der Ebene von `eye` und hat kein Objektiv, das unscharf macht</translation>
    </message>
    <message>
        <source>Aperture</source>
        <translation>Blende</translation>
    </message>
    <message>
        <source>Radius of the lens: the larger, the more is blurred before and behind the plane in focus; 0 is a pinhole, which has everything in focus</source>
        <translation>Radius des Objektivs: je größer, desto mehr ist vor und hinter der Schärfeebene unscharf; 0 ist eine Lochkamera, die alles scharf zeigt</translation>
    </message>
    <message>
        <source>Focus distance</source>
        <translation>Schärfeentfernung</translation>
    </message>
    <message>
        <source>Distance along the view axis of the plane in focus</source>
        <translation>Abstand der Schärfeebene entlang der Blickachse</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollwinkel</translation>
    </message>
    <message>
        <source>Turns the camera about the way it looks, after `up`: positive leans its top to its own right, so the picture turns to the left</source>
        <translation>Dreht die Kamera um ihre Blickrichtung, nach `up`: Positiv neigt ihr Oben nach ihrer rechten Seite, sodass sich das Bild nach links dreht</translation>
    </message>
    <message>
        <source>Copies per area of the surface that they are scattered over</source>
        <translation>Kopien pro Fläche der Oberfläche, auf die sie gestreut sind</translation>
    </message>
    <message>
        <source>Another seed gives other copies</source>
        <translation>Ein anderer Startwert gibt andere Kopien</translation>
    </message>
    <message>
        <source>The least and the greatest scale of a copy</source>
        <translation>Die kleinste und die größte Skalierung einer Kopie</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>How far a copy is turned about the normal at most, either way</source>
        <translation>Wie weit eine Kopie höchstens um die Normale gedreht ist, nach beiden Seiten</translation>
    </message>
    <message>
        <source>Where particles are born</source>
        <translation>Wo Partikel entstehen</translation>
    </message>
    <message>
        <source>Particles per second, from time 0 on; at most the 100,000 youngest are shown</source>
        <translation>Partikel pro Sekunde ab der Zeit 0; höchstens die 100.000 jüngsten werden gezeigt</translation>
    </message>
    <message>
        <source>Lifetime</source>
        <translation>Lebensdauer</translation>
    </message>
    <message>
        <source>Lifetime of a particle</source>
        <translation>Lebensdauer eines Partikels</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Velocity of a particle at birth</source>
        <translation>Geschwindigkeit eines Partikels bei der Geburt</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>The greatest random part of that velocity</source>
        <translation>Der größte zufällige Teil dieser Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Acceleration of particles</source>
        <translation>Beschleunigung der Partikel</translation>
    </message>
    <message>
        <source>Radius of a particle at birth and at death, linear in between</source>
        <translation>Radius eines Partikels bei Geburt und Tod, dazwischen linear</translation>
    </message>
    <message>
        <source>Density of a particle at birth and at death, linear in between</source>
        <translation>Dichte eines Partikels bei Geburt und Tod, dazwischen linear</translation>
    </message>
    <message>
        <source>Another seed gives other particles</source>
        <translation>Ein anderer Startwert gibt andere Partikel</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>`false`: it emits nothing</source>
        <translation>`false`: Er emittiert nichts</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>`true`: the editor does not change it in the view</source>
        <translation>`true`: Der Editor ändert ihn nicht in der Ansicht</translation>
    </message>
    <message>
        <source>Albedo of its particles, as gaussian.albedo</source>
        <translation>Albedo der Partikel, wie gaussian.albedo</translation>
    </message>
    <message>
        <source>Emission of a particle at birth, as gaussian.emission, linear until its death: fire that fades</source>
        <translation>Emission eines Partikels bei der Geburt, wie gaussian.emission, linear bis zum Tod: Feuer, das verlischt</translation>
    </message>
    <message>
        <source>Emission at death</source>
        <translation>Emission bei Tod</translation>
    </message>
    <message>
        <source>Emission of a particle at death</source>
        <translation>Emission eines Partikels bei seinem Tod</translation>
    </message>
    <message>
        <source>Scale of the radiance of map, sky and its sun</source>
        <translation>Faktor der Strahldichte von Bild, Himmel und dessen Sonne</translation>
    </message>
    <message>
        <source>Rotation about +y, of the sky's sun too</source>
        <translation>Drehung um +y, auch der Sonne des Himmels</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhe über dem Horizont</translation>
    </message>
    <message>
        <source>Elevation of the sun above the horizon; below it twilight, then night</source>
        <translation>Höhe der Sonne über dem Horizont; darunter Dämmerung, dann Nacht</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Where the sun is: 0 is -z, 90 is +x</source>
        <translation>Wo die Sonne ist: 0 ist -z, 90 ist +x</translation>
    </message>
    <message>
        <source>Turbidity</source>
        <translation>Trübung</translation>
    </message>
    <message>
        <source>Optical depth of air and haze relative to that of air alone, at 550 nm: 2 is clear, 6 hazy, 1 has no haze</source>
        <translation>Optische Tiefe von Luft und Dunst relativ zu der von Luft allein, bei 550 nm: 2 ist klar, 6 dunstig, 1 ohne Dunst</translation>
    </message>
    <message>
        <source>Ground albedo</source>
        <translation>Albedo des Bodens</translation>
    </message>
    <message>
        <source>Albedo of the ground, which is the lower half of the sky and lights the air from below</source>
        <translation>Albedo des Bodens, der die untere Hälfte des Himmels ist und die Luft von unten beleuchtet</translation>
    </message>
    <message>
        <source>`true`: the sun is a directional light of the scene; `false`: the sky is without it</source>
        <translation>`true`: Die Sonne ist ein gerichtetes Licht der Szene; `false`: Der Himmel ist ohne sie</translation>
    </message>
    <message>
        <source>Colour of its handles and outlines in the editor</source>
        <translation>Farbe der Griffe und Umrisse im Editor</translation>
    </message>
    <message>
        <source>`false` hides its Gaussians, and those of the groups in it: no frame has them</source>
        <translation>`false` blendet ihre Gaußfunktionen und die der Gruppen darin aus: Kein Bild hat sie</translation>
    </message>
    <message>
        <source>`true`: the editor selects and erases none of them</source>
        <translation>`true`: Der Editor wählt keine davon aus und radiert keine</translation>
    </message>
    <message>
        <source>Density factor</source>
        <translation>Faktor der Dichte</translation>
    </message>
    <message>
        <source>Multiplies the density of each Gaussian of the group; 1 changes nothing</source>
        <translation>Multipliziert die Dichte jeder Gaußfunktion der Gruppe; 1 ändert nichts</translation>
    </message>
    <message>
        <source>Density offset</source>
        <translation>Zuschlag der Dichte</translation>
    </message>
    <message>
        <source>Added to the density of each Gaussian after the factor; 0 changes nothing, and no density becomes negative</source>
        <translation>Wird nach dem Faktor zur Dichte jeder Gaußfunktion addiert; 0 ändert nichts, und keine Dichte wird negativ</translation>
    </message>
    <message>
        <source>Radius factor</source>
        <translation>Faktor des Radius</translation>
    </message>
    <message>
        <source>Multiplies the radius of each Gaussian of the group; 1 changes nothing</source>
        <translation>Multipliziert den Radius jeder Gaußfunktion der Gruppe; 1 ändert nichts</translation>
    </message>
    <message>
        <source>Radius offset</source>
        <translation>Zuschlag des Radius</translation>
    </message>
    <message>
        <source>Added to the radius of each Gaussian after the factor; 0 changes nothing</source>
        <translation>Wird nach dem Faktor zum Radius jeder Gaußfunktion addiert; 0 ändert nichts</translation>
    </message>
    <message>
        <source>Albedo factor</source>
        <translation>Faktor der Albedo</translation>
    </message>
    <message>
        <source>Multiplies the albedo of each Gaussian, its own or else the medium's; 1 changes nothing</source>
        <translation>Multipliziert die Albedo jeder Gaußfunktion, die eigene oder sonst die des Mediums; 1 ändert nichts</translation>
    </message>
    <message>
        <source>Albedo offset</source>
        <translation>Zuschlag der Albedo</translation>
    </message>
    <message>
        <source>Added to the albedo of each Gaussian after the factor; 0 changes nothing</source>
        <translation>Wird nach dem Faktor zur Albedo jeder Gaußfunktion addiert; 0 ändert nichts</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Shines in all directions</source>
        <translation>Scheint in alle Richtungen</translation>
    </message>
    <message>
        <source>Spot</source>
        <translation>Spot</translation>
    </message>
    <message>
        <source>Shines in a cone</source>
        <translation>Scheint in einem Kegel</translation>
    </message>
    <message>
        <source>Directional</source>
        <translation>Gerichtet</translation>
    </message>
    <message>
        <source>The sun: far away, its rays are parallel</source>
        <translation>Die Sonne: weit weg, ihre Strahlen sind parallel</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>A surface that shines</source>
        <translation>Eine Fläche, die leuchtet</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Disc light</source>
        <translation>Scheibenlicht</translation>
    </message>
    <message>
        <source>Where it is, of a surface its centre</source>
        <translation>Wo es ist, bei einer Fläche deren Mitte</translation>
    </message>
    <message>
        <source>Radiant intensity, RGB; of a spot on its axis, with a profile in its brightest direction</source>
        <translation>Strahlstärke, RGB; eines Spots auf seiner Achse, mit Profil in dessen hellster Richtung</translation>
    </message>
    <message>
        <source>Irradiance</source>
        <translation>Bestrahlungsstärke</translation>
    </message>
    <message>
        <source>Irradiance on a surface that faces it, without any medium, RGB</source>
        <translation>Bestrahlungsstärke auf einer zugewandten Fläche ohne Medium, RGB</translation>
    </message>
    <message>
        <source>Radiance</source>
        <translation>Strahldichte</translation>
    </message>
    <message>
        <source>Radiance of every point of it in every direction, RGB</source>
        <translation>Strahldichte jedes Punktes in jede Richtung, RGB</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>The way it shines, of a rectangle or disc the normal of the side that shines; of any length but 0</source>
        <translation>Wohin es scheint, bei Rechteck oder Scheibe die Normale der leuchtenden Seite; von jeder Länge außer 0</translation>
    </message>
    <message>
        <source>Its radius</source>
        <translation>Sein Radius</translation>
    </message>
    <message>
        <source>Two-sided</source>
        <translation>Beidseitig</translation>
    </message>
    <message>
        <source>Whether it shines to both sides; a sphere then also lights what is inside it</source>
        <translation>Ob es nach beiden Seiten scheint; eine Kugel beleuchtet dann auch, was in ihr ist</translation>
    </message>
    <message>
        <source>Whether the eye sees it, also in mirrors and through panes, from the sides that it shines to; it still keeps no light out</source>
        <translation>Ob das Auge es sieht, auch in Spiegeln und durch Scheiben, von den Seiten, nach denen es scheint; es hält trotzdem kein Licht ab</translation>
    </message>
    <message>
        <source>`false` turns it off and keeps its values</source>
        <translation>`false` schaltet es aus und behält seine Werte</translation>
    </message>
    <message>
        <source>Inner angle</source>
        <translation>Innerer Winkel</translation>
    </message>
    <message>
        <source>Angle from the axis within which its light is full, at most the outer one; equal angles make a hard edge</source>
        <translation>Winkel zur Achse, innerhalb dessen es voll leuchtet, höchstens der äußere; gleiche Winkel machen eine harte Kante</translation>
    </message>
    <message>
        <source>Outer angle</source>
        <translation>Äußerer Winkel</translation>
    </message>
    <message>
        <source>Angle from the axis beyond which it is dark, above 0</source>
        <translation>Winkel zur Achse, jenseits dessen es dunkel ist, über 0</translation>
    </message>
    <message>
        <source>Angular diameter</source>
        <translation>Winkeldurchmesser</translation>
    </message>
    <message>
        <source>Angle that its disc fills: the wider, the softer its shadows, at the cost of eight lights; the sun's is 0.53</source>
        <translation>Winkel, den seine Scheibe füllt: je weiter, desto weicher die Schatten, zum Preis von acht Lichtern; der der Sonne ist 0.53</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>Seine Breite</translation>
    </message>
    <message>
        <source>Its height</source>
        <translation>Seine Höhe</translation>
    </message>
    <message>
        <source>The direction of its height, as far as the normal leaves it</source>
        <translation>Die Richtung seiner Höhe, soweit die Normale sie lässt</translation>
    </message>
    <message>
        <source>Profile rotation</source>
        <translation>Drehung des Profils</translation>
    </message>
    <message>
        <source>Rotation of the profile about its axis, counterclockwise as seen against it; at 0 its horizontal angle 0 is +x, its 90 is −z</source>
        <translation>Drehung des Profils um seine Achse, gegen den Uhrzeigersinn, wenn man ihr entgegensieht; bei 0 ist der horizontale Winkel 0 +x, 90 ist −z</translation>
    </message>
    <message>
        <source>Texture rotation</source>
        <translation>Drehung der Textur</translation>
    </message>
    <message>
        <source>Rotation of the picture in its beam about the axis, counterclockwise as seen from the light</source>
        <translation>Drehung des Bildes im Kegel um die Achse, gegen den Uhrzeigersinn, vom Licht aus gesehen</translation>
    </message>
    <message>
        <source>Texture focus</source>
        <translation>Schärfe der Textur</translation>
    </message>
    <message>
        <source>How sharp the picture in its beam is: 1 sharp, 0 blurred to the size of the cone</source>
        <translation>Wie scharf das Bild im Kegel ist: 1 scharf, 0 unscharf bis zur Größe des Kegels</translation>
    </message>
    <message>
        <source>Diffuse albedo, of diffuse and phong materials</source>
        <translation>Diffuse Albedo, für diffuse und Phong-Materialien</translation>
    </message>
    <message>
        <source>Reflectance of the highlight of a phong material</source>
        <translation>Reflexionsgrad des Glanzlichts eines Phong-Materials</translation>
    </message>
    <message>
        <source>Exponent of a phong material: the higher, the smaller the highlight</source>
        <translation>Exponent eines Phong-Materials: je höher, desto kleiner das Glanzlicht</translation>
    </message>
    <message>
        <source>Reflectance of a metal at normal incidence, or of what lies below the surface of another material</source>
        <translation>Reflexionsgrad eines Metalls bei senkrechtem Einfall oder dessen, was unter der Oberfläche eines anderen Materials liegt</translation>
    </message>
    <message>
        <source>Metallic</source>
        <translation>Metallisch</translation>
    </message>
    <message>
        <source>From other materials, such as wood or plastic, to metal</source>
        <translation>Von anderen Materialien wie Holz oder Kunststoff bis zu Metall</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>From a mirror to almost diffuse</source>
        <translation>Vom Spiegel bis fast diffus</translation>
    </message>
    <message>
        <source>Emissive</source>
        <translation>Leuchtend</translation>
    </message>
    <message>
        <source>Radiance that the surface emits in W/(sr u^2), seen by the eye, and a light</source>
        <translation>Strahldichte in W/(sr u^2), die die Oberfläche abgibt, vom Auge gesehen und ein Licht</translation>
    </message>
    <message>
        <source>Normal scale</source>
        <translation>Faktor der Normalen</translation>
    </message>
    <message>
        <source>Multiplies the slopes of the normal map</source>
        <translation>Multipliziert die Neigungen der Normal Map</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Share of the surface that is there, of `cutout` and `blend`; times the alpha of the base colour texture</source>
        <translation>Anteil der Oberfläche, der da ist, für `cutout` und `blend`; mal das Alpha der Textur der Grundfarbe</translation>
    </message>
    <message>
        <source>Alpha cutoff</source>
        <translation>Alpha-Schwelle</translation>
    </message>
    <message>
        <source>Where less than this share is there, `cutout` has a hole</source>
        <translation>Wo weniger als dieser Anteil da ist, hat `cutout` ein Loch</translation>
    </message>
    <message>
        <source>Transmission</source>
        <translation>Transmission</translation>
    </message>
    <message>
        <source>Share of light that crosses the surface as a thin pane, unbent</source>
        <translation>Anteil des Lichts, der die Oberfläche wie eine dünne Scheibe ungebrochen durchquert</translation>
    </message>
    <message>
        <source>Single-scattering albedo: the fraction of the attenuated light that is scattered, the rest is absorbed</source>
        <translation>Albedo der Einfachstreuung: der Anteil des abgeschwächten Lichts, der gestreut wird, der Rest wird absorbiert</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>Anisotropie</translation>
    </message>
    <message>
        <source>g of the Henyey-Greenstein phase function: 0 isotropic, positive forward, negative backward</source>
        <translation>g der Phasenfunktion von Henyey und Greenstein: 0 isotrop, positiv vorwärts, negativ rückwärts</translation>
    </message>
    <message>
        <source>Homogeneous extent</source>
        <translation>Homogene Ausdehnung</translation>
    </message>
    <message>
        <source>How far homogeneous fog reaches from the middle of the scene, of the box around surfaces and Gaussians: it is in a ball of this radius</source>
        <translation>Wie weit homogener Nebel von der Mitte der Szene, des Quaders um Oberflächen und Gaußfunktionen, reicht: Er ist in einer Kugel dieses Radius</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Rms displacement of a ray over the radius of the Gaussian that it passes; 0 is off</source>
        <translation>RMS-Verschiebung eines Strahls relativ zum Radius der Gaußfunktion, die er durchquert; 0 ist aus</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Cells per u</source>
        <translation>Zellen pro u</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Velocity of the noise</source>
        <translation>Geschwindigkeit des Rauschens</translation>
    </message>
    <message>
        <source>Another seed gives another noise</source>
        <translation>Ein anderer Startwert gibt ein anderes Rauschen</translation>
    </message>
    <message>
        <source>`false` hides it: it is neither seen nor does it cast shadows or reflect light</source>
        <translation>`false` verbirgt sie: Sie ist nicht zu sehen, wirft keine Schatten und reflektiert kein Licht</translation>
    </message>
    <message>
        <source>`true`: the editor's view neither selects nor moves it</source>
        <translation>`true`: Die Ansicht des Editors wählt und bewegt sie nicht</translation>
    </message>
    <message>
        <source>Holdout</source>
        <translation>Holdout</translation>
    </message>
    <message>
        <source>`true`: the camera sees none of it, but what the picture is laid over, through the fog in front of it; it ends the fog, casts shadows and reflects light as ever</source>
        <translation>`true`: Die Kamera sieht nichts von ihr, an ihrer Stelle aber das, worüber das Bild gelegt wird, durch den Nebel davor; sie begrenzt den Nebel, wirft Schatten und reflektiert Licht wie sonst</translation>
    </message>
    <message>
        <source>By how much the homogeneous density rises</source>
        <translation>Um wie viel die homogene Dichte steigt</translation>
    </message>
    <message>
        <source>Gaussians that overlap are merged while lines through the fog keep their optical depth up to this, relative RMS</source>
        <translation>Überlappende Gaußfunktionen werden zusammengefasst, solange Linien durch den Nebel ihre optische Tiefe bis auf dies behalten, relativer RMS</translation>
    </message>
    <message>
        <source>Ellipsoids</source>
        <translation>Ellipsoide</translation>
    </message>
    <message>
        <source>What is merged may be ellipsoids: fewer are left along strands and layers of fog. Else it is balls</source>
        <translation>Zusammengefasstes darf Ellipsoide sein: Entlang von Strähnen und Schichten bleiben weniger. Sonst sind es Kugeln</translation>
    </message>
    <message>
        <source>The size of what is imported, over that in its file</source>
        <translation>Die Größe des Importierten relativ zu der in seiner Datei</translation>
    </message>
    <message>
        <source>Where the origin of the file is</source>
        <translation>Wo der Ursprung der Datei ist</translation>
    </message>
    <message>
        <source>Of height fog the middle of its footprint, on the ground</source>
        <translation>Bei Höhennebel die Mitte der Grundfläche, auf dem Boden</translation>
    </message>
    <message>
        <source>Edges or diameters; of height fog y is the height over which its density falls to 1/e, of a layer its thickness</source>
        <translation>Kanten oder Durchmesser; bei Höhennebel ist y die Höhe, über die die Dichte auf 1/e fällt, bei einer Schicht deren Dicke</translation>
    </message>
    <message>
        <source>Scattering coefficient within the shape; of height fog at the ground</source>
        <translation>Streukoeffizient in der Form; bei Höhennebel am Boden</translation>
    </message>
    <message>
        <source>Distance between Gaussians along y; their radius is 0.8 of it</source>
        <translation>Abstand der Gaußfunktionen entlang y; ihr Radius ist das 0,8-Fache davon</translation>
    </message>
    <message>
        <source>Flatness</source>
        <translation>Flachheit</translation>
    </message>
    <message>
        <source>So many times as wide as high are the Gaussians, and as far apart: fewer for layers</source>
        <translation>So vielmal breiter als hoch sind die Gaußfunktionen und so weit auseinander: weniger für Schichten</translation>
    </message>
    <message>
        <source>0: an even lattice; 1: random within its cells, so that the fog is patchy</source>
        <translation>0: ein gleichmäßiges Gitter; 1: zufällig in dessen Zellen, sodass der Nebel fleckig ist</translation>
    </message>
    <message>
        <source>Another number makes another pattern</source>
        <translation>Eine andere Zahl macht ein anderes Muster</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Where it rises from</source>
        <translation>Wovon sie aufsteigt</translation>
    </message>
    <message>
        <source>How high it rises</source>
        <translation>Wie hoch sie steigt</translation>
    </message>
    <message>
        <source>How wide it is at the foot</source>
        <translation>Wie breit sie am Fuß ist</translation>
    </message>
    <message>
        <source>By how much its radius grows, relative to the height risen</source>
        <translation>Um wie viel ihr Radius wächst, relativ zur gestiegenen Höhe</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>How far the wind moves its top</source>
        <translation>Wie weit der Wind ihr oberes Ende verschiebt</translation>
    </message>
    <message>
        <source>Scattering coefficient at the foot</source>
        <translation>Streukoeffizient am Fuß</translation>
    </message>
    <message>
        <source>How many Gaussians it is made of</source>
        <translation>Aus wie vielen Gaußfunktionen sie besteht</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>Turbulenz</translation>
    </message>
    <message>
        <source>How far Gaussians are off its axis, relative to its radius</source>
        <translation>Wie weit Gaußfunktionen von ihrer Achse weg sind, relativ zu ihrem Radius</translation>
    </message>
</context>
</TS>
