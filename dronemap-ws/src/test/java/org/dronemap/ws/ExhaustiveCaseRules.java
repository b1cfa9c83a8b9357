package org.dronemap.ws;

import com.tngtech.archunit.core.domain.InstanceofCheck;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaFieldAccess;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.Contention;
import org.dronemap.core.command.DeferredEffect;
import org.dronemap.core.command.ImmediateEffect;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;

/** Who handles commands and the like handles each kind of them: a forgotten one does not compile. */
final class ExhaustiveCaseRules {
    /** Sealed types, and the enum that each of their records has one constant of. */
    static final Map<Class<?>, Class<? extends Enum<?>>> FAMILIES = Map.of(
            Command.class, CommandKind.class,
            DroneEvent.class, DroneEvent.Kind.class,
            Setpoint.class, Setpoint.Kind.class,
            MissionItem.class, MissionItem.Kind.class,
            Outcome.class, Outcome.Kind.class);

    /** Classes that ask for two records or more of a family by themselves, each with its reason. */
    static final Map<String, String> ASKING_FOR_SEVERAL = Map.of(
            "org.dronemap.ws.command.CommandService", "It warns of places that look like slips, and forbids nothing.");

    /** Vehicles: what they do not say that they can they cannot, and refuse with a sentence. By their switch, each with its reason. */
    static final SortedMap<String, String> CANNOT_BY_DEFAULT = new TreeMap<>(Map.of(
            "org/dronemap/proxy/mavlink/translate/ArduPilotAdapter.java: switch (command.kind()) {",
            "The gate refuses what it does not declare, and AutopilotsTest asks for a way to do what it declares.",
            "org/dronemap/proxy/mavlink/translate/Px4Adapter.java: switch (command.kind()) {",
            "The gate refuses what it does not declare, and AutopilotsTest asks for a way to do what it declares.",
            "org/dronemap/proxy/roslink/RobotGoal.java: switch (command.kind()) {",
            "The gate refuses what a robot does not declare, and AimTest asks for an aim for what it declares."));

    /** By a name that stands in whatever switches over them. */
    private static final Map<Class<? extends Enum<?>>, String> SWITCHED = Map.ofEntries(
            Map.entry(CommandKind.class, "Command"),
            Map.entry(CommandKind.Purpose.class, "Command"),
            Map.entry(ImmediateEffect.class, "Command"),
            Map.entry(DeferredEffect.class, "Command"),
            Map.entry(Contention.class, "ontention"),
            Map.entry(DroneEvent.Kind.class, "DroneEvent"),
            Map.entry(DroneEvent.EarlyBuffering.class, "DroneEvent"),
            Map.entry(Setpoint.Kind.class, "Setpoint"),
            Map.entry(MissionItem.Kind.class, "MissionItem"),
            Map.entry(Outcome.Kind.class, "Outcome"),
            Map.entry(Capability.class, "Capability"),
            Map.entry(Capability.Readiness.class, "apability"),
            Map.entry(Capability.Part.class, "apability"));

    private static final Pattern DEFAULT = Pattern.compile("\\bdefault\\s*(->|:)");
    private static final Pattern SWITCH = Pattern.compile("\\bswitch\\s*\\(");
    private static final Pattern CASE = Pattern.compile("\\bcase\\s+([A-Z_]+(?:\\s*,\\s*[A-Z_]+)*)\\s*(?:->|:)");
    private static final Pattern LITERAL = Pattern.compile("\"([A-Z][A-Z0-9_]*)\"");

    /** As autopilots call them; MAV_TYPE of a copter, a plane, a rover, a submarine and a blimp, and both autopilots. */
    static final Set<String> MODES = Stream.of(2, 1, 10, 12, 7)
            .flatMap(type -> Stream.of(new Heartbeat(type, 3, 0, 0, 0, 3), new Heartbeat(type, 12, 0, 0, 0, 3)))
            .flatMap(heartbeat -> AutopilotAdapter.of(heartbeat).modes().stream())
            .collect(Collectors.toUnmodifiableSet());

    /** Literals that are called like modes, and why they stand where they do. */
    static final SortedMap<String, String> NAMING_MODES = new TreeMap<>(Map.of(
            "org/dronemap/ws/journal/FollowJournalCodec.java: GUIDED",
            "What journals say that were written before looks told of modes.",
            "org/dronemap/ws/journal/FollowJournalCodec.java: RTL",
            "What journals say that were written before looks told of modes."));

    /** Translators of their own family: what speaks MAVLink, and the modes that a bridge to mavros sets. */
    static boolean isAboveTranslators(String source) {
        return !source.startsWith("org/dronemap/proxy/mavlink/")
                && !source.equals("org/dronemap/proxy/roslink/RobotModes.java");
    }

    private ExhaustiveCaseRules() {}

    static Set<Class<?>> records(Class<?> family) {
        return Stream.of(family.getPermittedSubclasses())
                .flatMap(one -> one.isRecord() ? Stream.of(one) : records(one).stream())
                .collect(Collectors.toUnmodifiableSet());
    }

    /** The constants that a record's {@code kind()} names. */
    static Set<String> kinds(JavaClass record, Class<? extends Enum<?>> kind) {
        return record.getMethod("kind").getFieldAccesses().stream()
                .map(JavaFieldAccess::getTarget)
                .filter(field -> field.getOwner().isEquivalentTo(kind))
                .map(field -> field.getName())
                .collect(Collectors.toUnmodifiableSet());
    }

    /** Classes with a chain of instanceof over records of one family, and over which. */
    static Map<String, Set<String>> chains(JavaClasses classes) {
        Map<String, Set<String>> found = new TreeMap<>();
        for (Class<?> family : FAMILIES.keySet()) {
            Set<String> names = records(family).stream().map(Class::getName).collect(Collectors.toSet());
            for (JavaClass type : classes) {
                Set<String> asked = type.getInstanceofChecks().stream()
                        .map(InstanceofCheck::getRawType)
                        .map(JavaClass::getName)
                        .filter(names::contains)
                        .collect(Collectors.toCollection(TreeSet::new));
                if (asked.size() > 1) {
                    found.put(type.getName(), asked);
                }
            }
        }
        return found;
    }

    /** Switches over kinds with a default, which would take a new one in without anybody noticing. */
    static List<String> defaults(Map<String, String> sources) {
        return sources.entrySet().stream()
                .flatMap(source -> switches(source.getValue())
                        .filter(block -> DEFAULT.matcher(block).find() && isOverKinds(block, source.getValue()))
                        .map(block -> source.getKey() + ": "
                                + block.lines().findFirst().orElse("")))
                .sorted()
                .toList();
    }

    private static boolean isOverKinds(String block, String source) {
        Set<String> cases = CASE.matcher(block)
                .results()
                .flatMap(found -> Stream.of(found.group(1).split("\\s*,\\s*")))
                .collect(Collectors.toSet());
        return !cases.isEmpty()
                && SWITCHED.entrySet().stream()
                        .filter(kind -> source.contains(kind.getValue()))
                        .anyMatch(kind -> names(kind.getKey()).containsAll(cases));
    }

    private static Set<String> names(Class<? extends Enum<?>> kind) {
        return Stream.of(kind.getEnumConstants()).map(Enum::name).collect(Collectors.toSet());
    }

    /** From each switch to the end of its block. */
    private static Stream<String> switches(String source) {
        return SWITCH.matcher(source).results().map(found -> {
            int depth = 0;
            for (int at = source.indexOf('{', found.end()); at >= 0 && at < source.length(); at++) {
                depth += source.charAt(at) == '{' ? 1 : source.charAt(at) == '}' ? -1 : 0;
                if (depth == 0) {
                    return source.substring(found.start(), at);
                }
            }
            return "";
        });
    }

    /** Names of autopilots' modes that stand as literals. */
    static List<String> literals(Map<String, String> sources, Set<String> modes) {
        return sources.entrySet().stream()
                .flatMap(source -> LITERAL.matcher(source.getValue())
                        .results()
                        .map(found -> found.group(1))
                        .filter(modes::contains)
                        .map(mode -> source.getKey() + ": " + mode))
                .sorted()
                .distinct()
                .toList();
    }

    /** The sources that ship, of the modules that know of vehicles, by their names from there. */
    static Map<String, String> sources(Predicate<String> wanted) {
        Map<String, String> sources = new TreeMap<>();
        for (String module : List.of("core", "proxy", "cognitive", "store", "ws")) {
            Path root = Path.of("..", "dronemap-" + module, "src", "main", "java");
            try (Stream<Path> files = Files.walk(root)) {
                for (Path file :
                        files.filter(one -> one.toString().endsWith(".java")).toList()) {
                    String name = root.relativize(file).toString().replace('\\', '/');
                    if (wanted.test(name)) {
                        sources.put(name, Files.readString(file));
                    }
                }
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
        return sources;
    }
}
