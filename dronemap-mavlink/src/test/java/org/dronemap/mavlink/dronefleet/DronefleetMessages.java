package org.dronemap.mavlink.dronefleet;

import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/** All message classes that dronefleet carries, by id; where dialects share an id, the widely used one wins. */
final class DronefleetMessages {
    private DronefleetMessages() {}

    static TreeMap<Integer, Class<?>> all() throws IOException {
        TreeMap<Integer, Class<?>> found = new TreeMap<>();
        Path jar = Path.of(URI.create(MavlinkMessageInfo.class
                .getProtectionDomain()
                .getCodeSource()
                .getLocation()
                .toString()));
        try (FileSystem files = FileSystems.newFileSystem(jar, Map.of());
                Stream<Path> paths = Files.walk(files.getPath("/io/dronefleet/mavlink"))) {
            paths.map(Path::toString)
                    .filter(path -> path.endsWith(".class") && !path.contains("$"))
                    .sorted()
                    .map(path -> path.substring(1, path.length() - 6).replace('/', '.'))
                    .map(DronefleetMessages::load)
                    .filter(type -> type.isAnnotationPresent(MavlinkMessageInfo.class))
                    .forEach(type -> found.merge(
                            type.getAnnotation(MavlinkMessageInfo.class).id(),
                            type,
                            (one, other) -> rank(one) <= rank(other) ? one : other));
        }
        return found;
    }

    private static int rank(Class<?> type) {
        String name = type.getName();
        int rank = 0;
        for (String dialect : new String[] {".minimal.", ".standard.", ".common.", ".ardupilotmega."}) {
            if (name.contains(dialect)) {
                return rank;
            }
            rank++;
        }
        return rank;
    }

    private static Class<?> load(String name) {
        try {
            return Class.forName(name, false, DronefleetMessages.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }
}
