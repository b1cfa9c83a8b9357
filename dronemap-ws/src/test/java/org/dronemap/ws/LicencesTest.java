package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * What the product is built from may be given away with it: each library names, in its own description, a licence that goes
 * with Apache-2.0. Reads what the build has fetched anyway, so it asks nobody.
 */
class LicencesTest {
    /** As their makers write them; of several that are offered one is enough. */
    private static final Set<String> ALLOWED = Set.of(
            "apache-2.0",
            "apache 2.0",
            "apache license 2.0",
            "apache license, version 2.0",
            "apache software license, version 2.0",
            "the apache license, version 2.0",
            "the apache software license, version 2.0",
            "0bsd",
            "bouncy castle licence",
            "bsd",
            "bsd-2-clause",
            "bsd-3-clause",
            "the bsd 2-clause license",
            "cpl",
            "edl 1.0",
            "eclipse distribution license - v 1.0",
            "eclipse distribution license - version 1.0",
            "epl 2.0",
            "epl-2.0",
            "eclipse public license v2.0",
            "eclipse public license - version 2.0",
            "mit",
            "mit license",
            "the mit license");

    /** Beside those of libraries for Java: what the page is built from. */
    private static final Set<String> ALLOWED_IN_PAGES = Set.of(
            "MIT", "ISC", "BSD-2-Clause", "BSD-3-Clause", "Apache-2.0", "0BSD", "OFL-1.1", "(MIT OR Apache-2.0)");
    /** Of tools that build and test the page and do not go into it. */
    private static final Set<String> ALLOWED_IN_TOOLS =
            Set.of("MPL-2.0", "BlueOak-1.0.0", "CC-BY-4.0", "CC0-1.0", "(MIT OR CC0-1.0)", "Python-2.0");

    @Test
    void everyLibraryHasALicenceThatGoesWithOurs() throws Exception {
        List<Path> jars = Arrays.stream(classPath().split(java.io.File.pathSeparator))
                .filter(entry -> entry.endsWith(".jar"))
                .map(Path::of)
                .filter(jar -> Files.exists(description(jar)))
                .toList();
        List<String> others = new ArrayList<>();
        for (Path jar : jars) {
            List<String> licences = licences(description(jar));
            if (licences.stream()
                    .noneMatch(licence -> ALLOWED.contains(
                            licence.toLowerCase(java.util.Locale.ROOT).strip()))) {
                others.add(jar.getFileName() + " " + licences);
            }
        }

        assertThat(jars).hasSizeGreaterThan(80);
        assertThat(others).isEmpty();
    }

    /** The test runner may have hidden the class path in the manifest of a jar of its own. */
    private static String classPath() {
        return System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    }

    /** The build keeps it beside the library. */
    private static Path description(Path jar) {
        Path version = jar.getParent();
        Path name = version.getParent();
        return version.resolve(name.getFileName() + "-" + version.getFileName() + ".pom");
    }

    /** Its own, or those of what it descends from. */
    private static List<String> licences(Path description) throws Exception {
        Document document =
                DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(description.toFile());
        List<String> own = children(document.getDocumentElement(), "licenses")
                .flatMap(all -> children(all, "license"))
                .flatMap(one -> children(one, "name"))
                .map(name -> name.getTextContent().replaceAll("\\s+", " ").strip())
                .toList();
        Optional<Element> parent =
                children(document.getDocumentElement(), "parent").findFirst();
        if (!own.isEmpty() || parent.isEmpty()) {
            return own;
        }
        return licences(parentOf(description, document.getDocumentElement(), parent.get()));
    }

    private static Path parentOf(Path description, Element project, Element parent) {
        String group = text(project, "groupId");
        String ownGroup = group == null ? text(parent, "groupId") : group;
        Path repository = description.getParent().getParent().getParent();
        for (int depth = String.valueOf(ownGroup).split("\\.").length; depth > 0; depth--) {
            repository = repository.getParent();
        }
        String name = text(parent, "artifactId");
        String version = text(parent, "version");
        return repository
                .resolve(String.valueOf(text(parent, "groupId")).replace('.', '/'))
                .resolve(String.valueOf(name))
                .resolve(String.valueOf(version))
                .resolve(name + "-" + version + ".pom");
    }

    private static @Nullable String text(Element parent, String name) {
        return children(parent, name)
                .map(element -> element.getTextContent().strip())
                .findFirst()
                .orElse(null);
    }

    private static Stream<Element> children(Element parent, String name) {
        List<Element> found = new ArrayList<>();
        for (Node child = parent.getFirstChild(); child != null; child = child.getNextSibling()) {
            if (child instanceof Element element && element.getTagName().equals(name)) {
                found.add(element);
            }
        }
        return found.stream();
    }

    @Test
    void everyPackageOfThePageHasALicenceThatGoesWithOurs() throws Exception {
        JsonNode packages = new JsonMapper()
                .readTree(Files.readString(Path.of("..", "web-client", "package-lock.json")))
                .path("packages");
        List<String> others = new ArrayList<>();
        packages.properties().forEach(one -> {
            String licence = one.getValue().path("license").asString("none");
            boolean tool = one.getValue().path("dev").asBoolean(false);
            boolean fine = ALLOWED_IN_PAGES.contains(licence) || (tool && ALLOWED_IN_TOOLS.contains(licence));
            if (!one.getKey().isEmpty() && !fine) {
                others.add(one.getKey() + " " + licence);
            }
        });

        assertThat(packages.size()).isGreaterThan(100);
        assertThat(others).isEmpty();
    }
}
