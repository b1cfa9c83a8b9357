package org.dronemap.ws.zone;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.jspecify.annotations.Nullable;

/** The KML of a KMZ file, which is a ZIP: its first one, as KML has it, and the names of further ones. */
final class KmzFile {
    private static final int MOST_BYTES = 32 * 1024 * 1024;
    private static final int MOST_ENTRIES = 1_000;

    private final byte[] kml;
    private final List<String> others;

    private KmzFile(byte[] kml, List<String> others) {
        this.kml = kml;
        this.others = others;
    }

    byte[] kml() {
        return kml;
    }

    List<String> others() {
        return others;
    }

    static boolean isOne(byte[] file) {
        return file.length > 3 && file[0] == 'P' && file[1] == 'K' && file[2] == 3 && file[3] == 4;
    }

    static KmzFile of(byte[] file) {
        byte[] kml = null;
        List<String> others = new ArrayList<>();
        try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(file))) {
            int entries = 0;
            int room = MOST_BYTES;
            for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
                if (++entries > MOST_ENTRIES) {
                    throw unreadable("it has more than " + MOST_ENTRIES + " files in it");
                }
                // What is skipped is unpacked as well: everything counts.
                byte[] content = zip.readNBytes(room + 1);
                room -= content.length;
                if (room < 0) {
                    throw unreadable("unpacked it has more than 32 MB");
                }
                if (isKml(entry.getName())) {
                    kml = kml == null ? content : also(kml, others, entry.getName());
                }
            }
        } catch (IOException | IllegalArgumentException e) {
            throw unreadable("it cannot be unpacked");
        }
        return found(kml, others);
    }

    private static byte[] also(byte[] first, List<String> others, String name) {
        others.add(name);
        return first;
    }

    private static KmzFile found(byte @Nullable [] kml, List<String> others) {
        if (kml == null) {
            throw unreadable("there is no .kml file in it");
        }
        return new KmzFile(kml, List.copyOf(others));
    }

    private static boolean isKml(String name) {
        return name.toLowerCase(Locale.ROOT).endsWith(".kml") && !name.startsWith("__MACOSX/");
    }

    private static Rejection unreadable(String why) {
        return Rejection.of(RequestProblem.KML_UNREADABLE, "This is not KMZ that can be read: " + why + ".");
    }
}
