package org.dronemap.ws;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import com.tngtech.archunit.lang.syntax.ArchRuleDefinition;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Rooms of ws, and which of them see which: a floor sees the floors below it, every other room sees all floors, and further
 * rooms along these arrows alone.
 */
final class RoomRules {
    private static final String WS = "org.dronemap.ws.";
    /** Sees all, and is seen by none. */
    private static final String TOP = "wiring";

    /** From below to above. */
    static final List<String> FLOORS = List.of(
            "environment",
            "schedule",
            "problem",
            "reading",
            "budget",
            "account",
            "access",
            "security",
            "http",
            "stream");

    /** From a room to those that it sees. */
    static final Map<String, Set<String>> ARROWS = Stream.of(
                    "command: drone mission",
                    "control: drone outlet",
                    "dispatch: operation",
                    "drone: mission",
                    "enrol: drone organisation",
                    "fence: command drone",
                    "follow: operation",
                    "history: drone recording track",
                    "key: zone",
                    "link: drone",
                    "log: command drone",
                    "organisation: drone key zone",
                    "parameter: command drone",
                    "plan: command drone mission operation",
                    "recovery: operation",
                    "robotkey: link organisation",
                    "run: drone operation plan zone",
                    "system: history link outlet",
                    "user: key organisation",
                    "virtual: drone mission",
                    "zone: drone",
                    "settings: limit user",
                    "server: audit journal link operation outlet recording robotkey settings system")
            .map(line -> line.split(": "))
            .collect(Collectors.toUnmodifiableMap(line -> line[0], line -> Set.of(line[1].split(" "))));

    static final ArchRule ROOMS_SEE_OTHERS_ALONG_ARROWS_ALONE = ArchRuleDefinition.classes()
            .that()
            .resideInAPackage(WS + "*..")
            .should(new ArchCondition<JavaClass>("see other rooms along the arrows alone") {
                @Override
                public void check(JavaClass type, ConditionEvents events) {
                    String room = room(type).orElseThrow();
                    for (String other : seen(type)) {
                        if (!may(room, other)) {
                            String sees = type.getName() + " sees " + other + ", which " + room + " may not see";
                            events.add(SimpleConditionEvent.violated(type, sees));
                        }
                    }
                }
            });

    private RoomRules() {}

    /** Empty: of no room. */
    static Optional<String> room(JavaClass type) {
        String name = type.getPackageName() + ".";
        return name.startsWith(WS) && name.length() > WS.length()
                ? Optional.of(name.substring(WS.length()).replaceFirst("\\..*", ""))
                : Optional.empty();
    }

    /** Other rooms, with the floors. */
    static Set<String> seen(JavaClass type) {
        Set<String> seen = new TreeSet<>();
        type.getDirectDependenciesFromSelf()
                .forEach(each ->
                        room(each.getTargetClass().getBaseComponentType()).ifPresent(seen::add));
        room(type).ifPresent(seen::remove);
        return seen;
    }

    private static boolean may(String room, String other) {
        int floor = FLOORS.indexOf(room);
        int below = FLOORS.indexOf(other);
        return room.equals(TOP)
                || (below >= 0 && (floor < 0 || below < floor))
                || ARROWS.getOrDefault(room, Set.of()).contains(other);
    }
}
