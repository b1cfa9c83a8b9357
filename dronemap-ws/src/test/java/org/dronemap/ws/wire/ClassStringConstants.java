package org.dronemap.ws.wire;

import java.io.IOException;
import java.io.InputStream;
import java.util.Set;
import java.util.TreeSet;
import org.springframework.asm.ClassReader;

/** The texts that stand in the code of a class. */
final class ClassStringConstants {
    private static final int TEXT = 8;

    private ClassStringConstants() {}

    static Set<String> of(String className) throws IOException {
        String file = "/" + className.replace('.', '/') + ".class";
        try (InputStream in = ClassStringConstants.class.getResourceAsStream(file)) {
            if (in == null) {
                throw new IOException("there is no " + file);
            }
            return of(new ClassReader(in));
        }
    }

    private static Set<String> of(ClassReader code) {
        char[] buffer = new char[code.getMaxStringLength()];
        Set<String> words = new TreeSet<>();
        for (int item = 1; item < code.getItemCount(); item++) {
            int at = code.getItem(item);
            // Its tag stands just before an item.
            if (at > 0 && code.readByte(at - 1) == TEXT) {
                words.add(code.readUTF8(at, buffer));
            }
        }
        return words;
    }
}
