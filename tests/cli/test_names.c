/* test_names.c - names for labels: read from a file, in order; errors are reported with their lines. */
#include <stdio.h>
#include <unistd.h>

#include "cli/lists.h"
#include "temporary.h"
#include "testing.h"

static roberts_status read_names(const char *text, name_list *n, roberts_error *error)
{
    write_text("names.csv", text);
    *n = (name_list){0};
    *error = (roberts_error){0};
    return names_read(n, "names.csv", error);
}

static void in_order(void **state)
{
    (void)state;
    name_list n;
    roberts_error error;
    assert_int_equal(chdir(temporary), 0);
    assert_int_equal(
        read_names("\xef\xbb\xbf# all kinds\r\n\nface,3,Gr\xc3\xb6\xc3\x9f"
                   "e\r\nedge,9-2,a, b\nvertex,12,\nvertex,2,A\nbody,0,x\nbody,1,\"P, \"\"Q\"\"\"\nbody,2,\"\"\n"
                   "\"body\",\"3\",6\"",
                   &n, &error),
        ROBERTS_OK);
    static const roberts_name wanted[] = {{ROBERTS_LABEL_VERTICES, 2, 0, "A"},
                                          {ROBERTS_LABEL_VERTICES, 12, 0, ""},
                                          {ROBERTS_LABEL_EDGES, 2, 9, "a, b"},
                                          {ROBERTS_LABEL_FACES, 3, 0,
                                           "Gr\xc3\xb6\xc3\x9f"
                                           "e"},
                                          {ROBERTS_LABEL_BODIES, 0, 0, "x"},
                                          {ROBERTS_LABEL_BODIES, 1, 0, "P, \"Q\""},
                                          {ROBERTS_LABEL_BODIES, 2, 0, ""},
                                          {ROBERTS_LABEL_BODIES, 3, 0, "6\""}};
    assert_int_equal(n.count, 8);
    for (size_t i = 0; i < 8; i++) {
        assert_int_equal(n.item[i].of, wanted[i].of);
        assert_int_equal(n.item[i].number, wanted[i].number);
        assert_int_equal(n.item[i].other, wanted[i].other);
        assert_string_equal(n.item[i].text, wanted[i].text);
    }
    names_free(&n);
    assert_int_equal(read_names("", &n, &error), ROBERTS_OK);
    assert_int_equal(n.count, 0);
    names_free(&n);
}

/* Semicolons and tabs, capitals, blanks, and rows that are filled up with empty fields. */
static void spreadsheets(void **state)
{
    (void)state;
    static const char *const texts[] = {"Vertex;1;A;;\n;;;;\n EDGE ; v2-v7 ;a, b;\n",
                                        "vertex\tv1\tA\nedge\t7-2\ta, b\n",
                                        "\"vertex\",\"1\",\"A\",,\n,,,,\n\"edge\",\"v7-v2\",\"a, b\",,\n",
                                        "\xef\xbb\xbfkind,number,name\r\nvertex,1,A\r\nedge,2-7,\"a, b\"\r\n",
                                        "# mine\n\nKind;Number;Name;\nvertex;1;A;\nedge;v2-v7;a, b;\n"};
    assert_int_equal(chdir(temporary), 0);
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        name_list n;
        roberts_error error;
        if (read_names(texts[i], &n, &error) != ROBERTS_OK)
            fail_msg("%zu: %s", i, error.message);
        assert_int_equal(n.count, 2);
        assert_string_equal(n.item[0].text, "A");
        assert_true(n.item[0].number == 1 && n.item[1].number == 2 && n.item[1].other == 7);
        assert_string_equal(n.item[1].text, "a, b");
        names_free(&n);
    }
}

static void faults(void **state)
{
    (void)state;
    assert_int_equal(chdir(temporary), 0);
    static const struct {
        const char *text;
        size_t line;
        const char *message;
    } cases[] = {
        {"vertex,1,A\nvertx,2,B\n", 2, "the kind is none of vertex, edge, face and body"},
        {"vertx,2,B\nvertex,1,A\n", 1, "the kind is none of vertex, edge, face and body"},
        {"vertex,1,A\nkind,number,name\n", 2,
         "the kind is none of vertex, edge, face and body, and the second field is no number"},
        {"kind,number,name\nkind,number,name\n", 2,
         "the kind is none of vertex, edge, face and body, and the second field is no number"},
        {"vertex,number,name\n", 1, "the number is not a whole number from 0 on"},
        {"vertex 1 A\n", 1, "a line is KIND,NUMBER,NAME, as vertex,4,A or edge,4-17,a"},
        {"\n\nface,-1,A\n", 3, "the number is not a whole number from 0 on"},
        {"edge,4,A\n", 1,
         "an edge is named by its vertices, as 4-17 or v4-v17 (some spreadsheets take 4-7 for a date)"},
        {"vertex,1,\"A\",\"B\"\n", 1, "more fields follow the name; a name with commas stands in quotation marks"},
        {"face,v1,A\n", 1, "the number is not a whole number from 0 on"},
        {"edge,4-x,A\n", 1, "the number is not a whole number from 0 on"},
        {"vertex,1,\"A\n", 1,
         "a quotation mark opens this field, and none closes it at its end; two within it stand for one"},
        {"vertex,1,\"A\"B\n", 1,
         "a quotation mark opens this field, and none closes it at its end; two within it stand for one"},
        {"\"vertex\"x,1,A\n", 1,
         "a quotation mark opens this field, and none closes it at its end; two within it stand for one"},
        {"vertex,1,A\n\nvertex,1,B\n", 3, "vertex 1 has a name already, in line 1"},
        {"edge,4-7,A\nedge,7-4,B\n", 2, "edge 4-7 has a name already, in line 1"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        name_list n;
        roberts_error error;
        assert_int_equal(read_names(cases[i].text, &n, &error), ROBERTS_BAD_SYNTAX);
        assert_string_equal(error.message, cases[i].message);
        assert_string_equal(error.file, "names.csv");
        assert_int_equal(error.line, cases[i].line);
        names_free(&n);
    }
    name_list none = {0};
    roberts_error error = {0};
    assert_int_equal(names_read(&none, "nowhere.csv", &error), ROBERTS_IO);
    names_free(&none);
    none = (name_list){0};
    assert_int_equal(names_read(&none, ".", &error), ROBERTS_IO);
    assert_string_equal(error.message, "is a folder");
    names_free(&none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_setup_teardown(in_order, temporary_make, temporary_remove),
                                       cmocka_unit_test_setup_teardown(spreadsheets, temporary_make, temporary_remove),
                                       cmocka_unit_test_setup_teardown(faults, temporary_make, temporary_remove)};
    return cmocka_run_group_tests_name("names", tests, NULL, NULL);
}
