package org.dronemap.ws.wire;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * What is called otherwise in each run, such as ids and secrets, and the names that stand for it in files. A name is bound by
 * the first answer that has it in its file: to what stands in that place of what the server says now.
 */
final class Placeholders {
    private static final Pattern NAME = Pattern.compile("<(?:id|secret)-(\\d+)>");
    private static final Pattern FILLER = Pattern.compile("<filler-(\\d+)>");
    private static final Pattern TIME = Pattern.compile(
            "\\d{4}-\\d\\d-\\d\\d[T ]\\d\\d:\\d\\d(?::\\d\\d(?:\\.\\d+)?)?(?:Z| UTC)" + "|(?<=Expires=)[^;]+");
    private static final String VALUE = "([A-Za-z0-9_-]{6,})";
    private static final String IDS = "id|drone|droneId|command|commandId|plan|planId|run|runId|follow|followId|flight"
            + "|flightId|mission|zone|grant|group|fleet|recording|virtualDrone|virtualDroneId|endpoint|account|identity";
    private static final String SECRETS = "key|secret|ticket|token|password|oneTimePassword|invitation";
    private static final List<Pattern> FRESH = List.of(
            Pattern.compile("\"(?:" + IDS + ")\" : \"()" + VALUE + "\""),
            Pattern.compile("<(?:\\w+:)?(?:" + IDS + ")>()" + VALUE + "<"),
            Pattern.compile("\"(" + SECRETS + ")\" : \"" + VALUE + "\""),
            // Of an invitation; what a problem is called is the same in each run.
            Pattern.compile("\"(code)\" : \"(?![a-z]+(?:-[a-z]+)+\")" + VALUE + "\""),
            Pattern.compile("<(?:\\w+:)?(" + SECRETS + ")>" + VALUE + "<"),
            Pattern.compile("(dronemap-session)=" + VALUE + ";"));
    /** Members that are measured, or counted by clocks. */
    private static final Pattern MEASURED = Pattern.compile(
            "(\"(?:uptimeSeconds|seconds|sequence|written|journal|latencyMillis|version|epoch|retryAfterSeconds|rttMs)\" : |Retry-After: |<version>)-?[\\d.]+(?:E-?\\d+)?");

    /** Of records that say when things happened. */
    private static final Pattern HASH = Pattern.compile("(?<=\"hash\" : \")[0-9a-f]{64}");

    /** How far a drone of a run is when it is looked at, and what becomes of it when the run is stopped then. */
    private static final Pattern STAGE = Pattern.compile("(?<=\"stage\" : \")[a-zA-Z]+");

    private static final Pattern STOPPED = Pattern.compile("(?<=[0-9]) (?:stays where it is|comes home)\\.");

    /** What these vehicles, which say each thing once, have not said again; on a slow machine that is more. */
    private static final Pattern OUTDATED =
            Pattern.compile("(?s)(\"outdated\" : )\\[[^\\]]*]|<outdated>.*?(?=</link>)");

    /** Which of them a plan, or an order that nobody has carried out yet, is at first is a matter of luck. */
    private static final Pattern NEW =
            Pattern.compile("(\"(?:state|phase)\" : \"|<state>)(?:(queued|running)|sent|accepted)\\b");

    private final Map<String, String> values = new LinkedHashMap<>();

    void bind(String name, String value) {
        values.put(name, value);
    }

    /** With the names replaced by what they stand for. */
    String filled(String text) {
        String filled = text;
        for (Map.Entry<String, String> bound : values.entrySet()) {
            filled = filled.replace(bound.getKey(), bound.getValue());
        }
        return FILLER.matcher(filled).replaceAll(found -> "x".repeat(Integer.parseInt(found.group(1))));
    }

    /** The names in these files; what is bound later gets higher numbers. */
    static int highest(List<RecordedHttpExchange> exchanges) {
        return exchanges.stream()
                .flatMap(exchange -> NAME.matcher(exchange.answer()).results())
                .mapToInt(found -> Integer.parseInt(found.group(1)))
                .max()
                .orElse(0);
    }

    /** Binds the names that the file has for the first time, to what stands in their places. */
    void learn(String expected, String actual) {
        List<String> lines = actual.lines().toList();
        int from = 0;
        for (String line : expected.lines().toList()) {
            String open = line.strip();
            if (!NAME.matcher(without(open)).find()) {
                continue;
            }
            Template template = Template.of(timeless(filled(open)));
            for (int at = from; at < lines.size(); at++) {
                if (template.binds(lines.get(at).strip(), values)) {
                    from = at + 1;
                    break;
                }
            }
        }
    }

    private String without(String line) {
        String rest = line;
        for (String name : values.keySet()) {
            rest = rest.replace(name, "");
        }
        return rest;
    }

    /** Gives a name to each value that wants one and has none, but for what clients chose themselves. */
    int name(String actual, String chosen, int highest) {
        int number = highest;
        for (Pattern pattern : FRESH) {
            Matcher found = pattern.matcher(actual);
            while (found.find()) {
                if (!values.containsValue(found.group(2)) && !chosen.contains(found.group(2))) {
                    number++;
                    String kind = found.group(1).isEmpty() ? "id" : "secret";
                    values.put("<" + kind + "-" + number + ">", found.group(2));
                }
            }
        }
        return number;
    }

    /** As a file has it. */
    String shown(String actual) {
        String shown = actual;
        List<Map.Entry<String, String>> longestFirst = values.entrySet().stream()
                .sorted((one, other) ->
                        other.getValue().length() - one.getValue().length())
                .toList();
        for (Map.Entry<String, String> bound : longestFirst) {
            shown = Pattern.compile("(?<![\\w-])" + Pattern.quote(bound.getValue()) + "(?![\\w-])")
                    .matcher(shown)
                    .replaceAll(Matcher.quoteReplacement(bound.getKey()));
        }
        shown = NEW.matcher(shown)
                .replaceAll(found ->
                        found.group(1) + (found.group(2) == null ? "<sent or accepted>" : "<queued or running>"));
        shown = OUTDATED.matcher(shown)
                .replaceAll(found -> found.group(1) == null ? "<outdated/>\n" : found.group(1) + "[ ]");
        return timeless(shown);
    }

    /** Without what is measured, or told by clocks. */
    private static String timeless(String text) {
        String rest = HASH.matcher(TIME.matcher(text).replaceAll("<time>")).replaceAll("<hash>");
        rest = STAGE.matcher(rest).replaceAll("<stage>");
        rest = STOPPED.matcher(rest).replaceAll(" <what it does by its stage>.");
        return MEASURED.matcher(rest).replaceAll("$1<number>");
    }

    Placeholders copy() {
        Placeholders copy = new Placeholders();
        copy.values.putAll(values);
        return copy;
    }

    /** A line with names that are still open. */
    private record Template(Pattern pattern, List<String> names) {
        static Template of(String line) {
            Matcher names = NAME.matcher(line);
            StringBuilder pattern = new StringBuilder();
            List<String> open = new ArrayList<>();
            int end = 0;
            while (names.find()) {
                pattern.append(quoted(line.substring(end, names.start()))).append("([\\w-]+)");
                open.add(names.group());
                end = names.end();
            }
            String rest = line.substring(end);
            pattern.append(quoted(rest.endsWith(",") ? rest.substring(0, rest.length() - 1) : rest))
                    .append(",?");
            return new Template(Pattern.compile(pattern.toString()), open);
        }

        private static String quoted(String text) {
            return Pattern.quote(text).replace("<time>", "\\E.*?\\Q").replace("<number>", "\\E.*?\\Q");
        }

        boolean binds(String line, Map<String, String> values) {
            Matcher found = pattern.matcher(line);
            if (!found.matches()
                    || IntStream.range(0, names.size()).anyMatch(at -> values.containsValue(found.group(at + 1)))) {
                return false;
            }
            for (int index = 0; index < names.size(); index++) {
                values.put(names.get(index), found.group(index + 1));
            }
            return true;
        }
    }
}
