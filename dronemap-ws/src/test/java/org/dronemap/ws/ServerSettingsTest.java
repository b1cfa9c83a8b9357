package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.history.HistoryPolicy;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.separation.Separation;
import org.dronemap.ws.budget.WorkKind;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.dronemap.ws.settings.ServerSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ServerSettingsTest {

    @Test
    void listensOnLoopbackUnlessToldOtherwise() {
        ServerSettings settings = ServerSettings.fromEnvironment(Map.of());

        assertThat(settings.bindAddress()).isEqualTo("127.0.0.1");
        assertThat(settings.endpoints()).containsExactly("udpserver://127.0.0.1:14550", "tcpserver://127.0.0.1:5760");
        assertThat(settings.httpPort()).isEqualTo(8080);
        assertThat(settings.streamPort()).isEqualTo(8081);
        assertThat(settings.publicMode()).isFalse();
    }

    @Test
    void scalesTheWatchdog() {
        ServerSettings settings = ServerSettings.fromEnvironment(Map.of("DRONEMAP_WATCHDOG_LOST_SECONDS", "10"));

        assertThat(settings.watchdog().lostAfter()).isEqualTo(Duration.ofSeconds(10));
        assertThat(settings.watchdog().probeAfter()).isEqualTo(Duration.ofSeconds(6));
    }

    @Test
    void boundsWorkUnlessToldOtherwise() {
        assertThat(ServerSettings.fromEnvironment(Map.of()).protection()).isEqualTo(ServerSettings.Protection.DEFAULT);
        assertThat(ServerSettings.Protection.DEFAULT.rates().perSecond())
                .as("as docs/security.md says")
                .isEqualTo(Map.of(
                        WorkKind.REQUEST, 200.0, WorkKind.COMMAND, 50.0, WorkKind.EXPORT, 5.0, WorkKind.SIGN_IN, 5.0));
        ServerSettings.Protection own = ServerSettings.fromEnvironment(Map.of(
                        "DRONEMAP_RATE_COMMANDS", "0",
                        "DRONEMAP_RATE_REQUESTS", "7",
                        "DRONEMAP_STREAMS_PER_USER", "2",
                        "DRONEMAP_SLOW_CLIENT_SECONDS", "3"))
                .protection();

        assertThat(own.rates().perSecond()).doesNotContainKey(WorkKind.COMMAND).containsEntry(WorkKind.REQUEST, 7.0);
        assertThat(own.streamsPerUser()).isEqualTo(2);
        assertThat(own.clients().patience()).isEqualTo(Duration.ofSeconds(3));
    }

    @Test
    void remembersAsOftenAndAsLongAsItIsTold() {
        assertThat(ServerSettings.fromEnvironment(Map.of()).history()).isEqualTo(HistoryPolicy.DEFAULT);
        HistoryPolicy own = ServerSettings.fromEnvironment(Map.of(
                        "DRONEMAP_TELEMETRY_RATE", "0.1",
                        "DRONEMAP_TELEMETRY_FULL_DAYS", "7",
                        "DRONEMAP_TELEMETRY_DAYS", "0"))
                .history();

        assertThat(own.flying()).isEqualTo(Duration.ofSeconds(10));
        assertThat(own.resting()).isEqualTo(Duration.ofSeconds(10));
        assertThat(own.retention().fullDays()).isEqualTo(7);
        assertThat(own.retention().keepDays()).isZero();
        assertThat(ServerSettings.fromEnvironment(Map.of("DRONEMAP_MONGODB_URL", "mongodb://u:secret@h"))
                        .toString())
                .doesNotContain("secret");
    }

    @ParameterizedTest
    @CsvSource({
        "DRONEMAP_TELEMETRY_RATE,51",
        "DRONEMAP_TELEMETRY_RATE,often",
        "DRONEMAP_TELEMETRY_DAYS,-1",
        "DRONEMAP_TELEMETRY_FULL_DAYS,10001"
    })
    void refusesToRememberOtherwiseThanCanBe(String name, String value) {
        assertThatThrownBy(() -> ServerSettings.fromEnvironment(Map.of(name, value)))
                .isInstanceOf(SetupException.class)
                .hasMessageContaining(name);
    }

    @Test
    void readsTheProviderAndHidesItsSecret() {
        OidcSettings oidc = ServerSettings.fromEnvironment(Map.of(
                        "DRONEMAP_OIDC_ISSUER", "https://login.example.org/realms/fleet",
                        "DRONEMAP_OIDC_ADDRESS", "https://drones.example.org/",
                        "DRONEMAP_OIDC_CLIENT_ID", "dronemap",
                        "DRONEMAP_OIDC_CLIENT_SECRET", "canary",
                        "DRONEMAP_OIDC_ROLE_CLAIM", "groups",
                        "DRONEMAP_OIDC_ROLES", "pilots=operator, the office=viewer"))
                .oidc();

        assertThat(oidc).isNotNull();
        assertThat(oidc.callback()).hasToString("https://drones.example.org/api/v1/session/oidc/callback");
        assertThat(oidc.label()).isEqualTo("login.example.org");
        assertThat(oidc.newAccounts()).isEqualTo(AccountState.WAITING);
        assertThat(oidc.roles().byValue())
                .containsOnly(Map.entry("pilots", Role.OPERATOR), Map.entry("the office", Role.VIEWER));
        assertThat(oidc.toString()).doesNotContain("canary");
    }

    @Test
    void keepsDronesThatFollowAsFarApartAsItIsTold() {
        assertThat(ServerSettings.fromEnvironment(Map.of()).apart()).isEqualTo(Separation.USUAL);
        assertThat(ServerSettings.fromEnvironment(Map.of(
                                "DRONEMAP_SEPARATION_METERS", "12.5",
                                "DRONEMAP_SEPARATION_HEIGHT_METERS", "30"))
                        .apart())
                .isEqualTo(new Separation(12.5, 30));
    }

    @Test
    void recordsFlightsUnlessToldOtherwise() {
        assertThat(ServerSettings.fromEnvironment(Map.of()).recording()).isEqualTo(RecordingPolicy.DEFAULT);
        assertThat(ServerSettings.fromEnvironment(Map.of(
                                "DRONEMAP_RECORD", "always",
                                "DRONEMAP_RECORD_MEGABYTES", "50",
                                "DRONEMAP_RECORD_DAYS", "30"))
                        .recording())
                .isEqualTo(new RecordingPolicy(RecordingPolicy.When.ALWAYS, 50_000_000, 30));
    }

    @ParameterizedTest
    @CsvSource({
        "DRONEMAP_HTTP_PORT, 99999, '\"99999\"'",
        "DRONEMAP_STREAM_PORT, web, '\"web\"'",
        "DRONEMAP_PUBLIC, perhaps, '\"perhaps\"'",
        "DRONEMAP_PUBLIC, true, DRONEMAP_TLS_CERT",
        "DRONEMAP_TLS_CERT, /no/such/file, /no/such/file",
        "DRONEMAP_TILE_ADDRESS, tiles, '\"tiles\"'",
        "DRONEMAP_WATCHDOG_LOST_SECONDS, 1, 2 to 600 seconds",
        "DRONEMAP_RECORD, sometimes, 'flights, always or never'",
        "DRONEMAP_RECORD_MEGABYTES, 0, 'from 1 to 10000000'",
        "DRONEMAP_RECORD_DAYS, -1, '\"-1\"'",
        "DRONEMAP_ENROLMENT, somewhere, nowhere",
        "DRONEMAP_REGISTRATION, everybody, 'approval, invitation or off'",
        "DRONEMAP_RATE_COMMANDS, many, '\"many\"'",
        "DRONEMAP_CONNECTIONS_PER_ADDRESS, 0, 'from 1 to 2000'",
        "DRONEMAP_STREAMS_PER_USER, 2001, 'from 1 to 2000'",
        "DRONEMAP_SLOW_CLIENT_SECONDS, 301, 'from 1 to 300'",
        "DRONEMAP_OIDC_ISSUER, http://login.example.org, 'https://login.example.org'",
        "DRONEMAP_OIDC_ISSUER, https://login.example.org, DRONEMAP_OIDC_ADDRESS",
        "DRONEMAP_FOLLOW_SEPARATION_METERS, 12, 'now called DRONEMAP_SEPARATION_METERS'",
        "DRONEMAP_FOLLOW_SEPARATION_HEIGHT_METERS, 6, 'now called DRONEMAP_SEPARATION_HEIGHT_METERS'",
        "DRONEMAP_SEPARATION_METERS, 7.9, '8 to 50 metres, not \"7.9\"'",
        "DRONEMAP_SEPARATION_METERS, NaN, '8 to 50 metres'",
        "DRONEMAP_SEPARATION_HEIGHT_METERS, 31, '3 to 30 metres, not \"31\"'",
        "DRONEMAP_STREAM_PORT, 8080, 8080"
    })
    void namesTheSettingAndTheValueThatAreWrong(String name, String value, String named) {
        assertThatThrownBy(() -> ServerSettings.fromEnvironment(Map.of(name, value)))
                .isInstanceOf(SetupException.class)
                .hasMessageContaining(name)
                .hasMessageContaining(named);
    }

    @Test
    void hasNoPlainAddressesOfThePastBesideTls(@TempDir Path folder) throws IOException {
        String pem = Files.createFile(folder.resolve("some.pem")).toString();
        Map<String, String> encrypted = Map.of("DRONEMAP_TLS_CERT", pem, "DRONEMAP_TLS_KEY", pem);
        Map<String, String> both = new HashMap<>(encrypted);
        both.put("DRONEMAP_ORIGINAL_ADDRESSES", "true");

        assertThat(ServerSettings.fromEnvironment(encrypted).originalAddresses())
                .isFalse();
        assertThatThrownBy(() -> ServerSettings.fromEnvironment(both))
                .isInstanceOf(SetupException.class)
                .hasMessageContaining("DRONEMAP_ORIGINAL_ADDRESSES cannot be on with TLS");
    }
}
