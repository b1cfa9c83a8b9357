package org.dronemap.ws.account;

import java.lang.Character.UnicodeScript;
import java.text.Normalizer;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Rules for user names: allowed form and names that look alike. */
public final class UserNameRules {
    private static final String FORM = "1 to 40 of letters of one script, digits, '.', '_', '-' and '@'";
    private static final Set<UnicodeScript> OF_ANY = EnumSet.of(UnicodeScript.COMMON, UnicodeScript.INHERITED);
    private static final Set<UnicodeScript> JAPANESE =
            EnumSet.of(UnicodeScript.HAN, UnicodeScript.HIRAGANA, UnicodeScript.KATAKANA);
    /** Small letters and digits that look like those of {@link #LATIN}, place by place: Cyrillic, Greek, digits. */
    private static final String LOOK_ALIKE =
            "\u0430\u0432\u0435\u043a\u043c\u043d\u043e\u0440\u0441\u0442\u0443\u0445\u0456\u0458"
                    + "\u0455\u0501\u04bb\u051b\u051d\u03b1\u03b2\u03b5\u03b9\u03ba\u03bd\u03bf\u03c1\u03c4\u03c5\u03c7"
                    + "01l";

    private static final String LATIN = "abekmhopctyxij" + "sdhqwabeikvoptux" + "oii";

    private UserNameRules() {}

    public static String checked(@Nullable String name) {
        if (name == null) {
            throw InvalidInput.missing("name", FORM);
        }
        if (!name.matches("[\\p{L}\\p{N}._@-]{1,40}") || !isOfOneScript(name)) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, "name", FORM, "\"" + name + "\"");
        }
        return name;
    }

    private static boolean isOfOneScript(String name) {
        Set<UnicodeScript> scripts = EnumSet.noneOf(UnicodeScript.class);
        name.codePoints().mapToObj(UnicodeScript::of).forEach(scripts::add);
        scripts.removeAll(OF_ANY);
        return scripts.size() <= 1 || JAPANESE.containsAll(scripts);
    }

    static boolean lookAlike(String one, String other) {
        return shape(one).equals(shape(other));
    }

    private static String shape(String name) {
        StringBuilder shape = new StringBuilder();
        Normalizer.normalize(name, Normalizer.Form.NFKC)
                .toLowerCase(Locale.ROOT)
                .chars()
                .forEach(each -> {
                    int at = LOOK_ALIKE.indexOf(each);
                    shape.append(at < 0 ? (char) each : LATIN.charAt(at));
                });
        return shape.toString();
    }
}
